// The page of `blocks view`: what it carries. How it behaves is tested in a browser by
// view_page_test.py.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "post/view_data.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The page shows the float to six digits; they must be those of the double. A plain
// conversion to float loses this where a digit is about to turn.
TEST(View, SixDigitsSurviveTheFloat) {
  std::mt19937_64 random(1982);
  std::uniform_real_distribution<double> mantissa(1, 10);
  std::uniform_int_distribution<int> power(-30, 30);
  int plain_fails = 0;
  const auto digits = [](double value) { return fmt::format("{:.6g}", value); };
  for (int i = 0; i < 100000; ++i) {
    const double value =
        (i % 2 ? -1 : 1) * mantissa(random) * std::pow(10.0, power(random));
    const double kept = post::six_digits(value);
    ASSERT_EQ(digits(kept), digits(value));
    plain_fails += digits(static_cast<float>(value)) != digits(value);
  }
  EXPECT_GT(plain_fails, 0);
  EXPECT_EQ(post::six_digits(1e-40), 0.0F);
}

TEST(View, WritesOnePageAndKeepsTheOlder) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\nCYCLE, 9\n");
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(blocks("view fall.vtkhdf", folder.path()).code, 0);
  EXPECT_TRUE(folder.holds("fall.html.bak"));
  const std::string page = slurp(folder / "fall.html");
  EXPECT_THAT(page, HasSubstr("\"blocks\":1"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

// A title ends neither the script nor the page.
TEST(View, TitleIsOnlyText) {
  const TemporaryFolder folder;
  std::string deck = preliminary();
  const auto line = deck.find('\n') + 1;
  deck.replace(line, deck.find('\n', line) - line, "</script><script>alert(1)");
  run_text(folder, "fall", deck + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  ASSERT_EQ(blocks("view fall.vtkhdf", folder.path()).code, 0);
  const std::string page = slurp(folder / "fall.html");
  EXPECT_THAT(page, HasSubstr("\\u003c/script>"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

TEST(View, RefusalsNameTheFile) {
  const TemporaryFolder folder;
  folder.write("text.vtkhdf", "no results");
  for (const char* name : {"text.vtkhdf", "none.vtkhdf"}) {
    const Outcome run = blocks(std::string("view ") + name, folder.path());
    EXPECT_EQ(run.code, 5);
    EXPECT_THAT(run.err, HasSubstr(std::string("cannot read ") + name));
  }
  EXPECT_FALSE(folder.holds("text.html"));
  EXPECT_EQ(blocks("view none.vtkhdf --every 0", folder.path()).code, 2);
}

}  // namespace
}  // namespace blocks::testing
