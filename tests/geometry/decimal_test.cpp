#include "geometry/decimal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace blocks::geometry {
namespace {

struct Form {
  const char* text;
  const char* digits;
  long exponent;
};

TEST(Decimal, KeepsAllDigitsInACanonicalForm) {
  for (const Form& form :
       {Form{"0.2", "2", -1}, Form{"+.5", "5", -1}, Form{"5.", "5", 0},
        Form{"-1.50D+2", "-15", 1}, Form{"007", "7", 0}, Form{"2e3", "2", 3},
        Form{"1d-3", "1", -3}, Form{"-0.0", "0", 0}, Form{"0e99999999999", "0", 0},
        Form{"0.1000000000000000055511151231257827",
             "1000000000000000055511151231257827", -34}}) {
    const auto decimal = Decimal::parse(form.text);
    ASSERT_TRUE(decimal) << form.text;
    EXPECT_EQ(decimal->digits(), form.digits) << form.text;
    EXPECT_EQ(decimal->exponent(), form.exponent) << form.text;
  }
}

TEST(Decimal, RefusesTextThatIsNoDecimal) {
  for (const char* text : {"", "+", ".", "e5", "1e", "1e+", "--1", "1 ", " 1", "1,0",
                           "nan", "inf", "-Infinity", "0x10", "1f", "1.2.3", "1e5.0"}) {
    EXPECT_FALSE(Decimal::parse(text)) << '"' << text << '"';
  }
}

TEST(Decimal, RefusesNumbersOutsideTheRangeOfDoubles) {
  EXPECT_FALSE(Decimal::parse("1e400"));
  EXPECT_FALSE(Decimal::parse("-1.8e308"));
  EXPECT_TRUE(Decimal::parse("1.7976931348623157e308"));
  // The exact value would need a million digits.
  EXPECT_FALSE(Decimal::parse("1e-300000"));
  EXPECT_FALSE(Decimal::parse("1e99999999999999999999"));
}

TEST(Decimal, KeepsDigitsOfNumbersBelowTheSmallestDouble) {
  const auto tiny = Decimal::parse("-3e-399");
  ASSERT_TRUE(tiny);
  EXPECT_EQ(tiny->digits(), "-3");
  EXPECT_EQ(tiny->value(), 0.0);
  EXPECT_EQ(Decimal::parse("3e-324")->value(),
            std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(Decimal::parse("2e-324")->value(), 0.0);
}

TEST(Decimal, ValueIsTheNearestDouble) {
  // The first value is half way between two doubles and rounds to even. The second is
  // just above and rounds up.
  EXPECT_EQ(Decimal::parse("9007199254740993")->value(), 9007199254740992.0);
  EXPECT_EQ(Decimal::parse("9007199254740993.0000000000000000001")->value(),
            9007199254740994.0);
  for (const char* text : {"0.1", "-123.456e-7", "2.2250738585072011e-308", "1e23"}) {
    EXPECT_EQ(Decimal::parse(text)->value(), std::strtod(text, nullptr)) << text;
  }
}

TEST(Decimal, IsTheSameFromAnIntegerAndFromItsText) {
  for (const int value : {0, 1, -10, 1200, std::numeric_limits<int>::min()}) {
    const Decimal number(value);
    const auto text = Decimal::parse(std::to_string(value));
    EXPECT_EQ(number.digits(), text->digits());
    EXPECT_EQ(number.exponent(), text->exponent());
    EXPECT_EQ(number.value(), text->value());
  }
}

}  // namespace
}  // namespace blocks::geometry
