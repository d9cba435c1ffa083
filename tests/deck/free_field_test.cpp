#include "deck/free_field.hpp"

#include <gtest/gtest.h>

namespace blocks::deck {
namespace {

/// Returns the fields of a line with their columns.
std::string joined(std::string_view text) {
  std::string out;
  for (const Field& field : split_fields(text, 1).fields) {
    out += (field.blank ? "<>" : field.text) + "@" +
           std::to_string(field.where.column) + " ";
  }
  return out;
}

// Blanks separate fields where there is no comma. A field between two commas may be
// blank.
TEST(FreeField, SplitsAtCommasAndBlanks) {
  EXPECT_EQ(joined("START, 10, 4"), "START@1 10@8 4@12 ");
  EXPECT_EQ(joined("XLIMITS 0.\t10."), "XLIMITS@1 0.@9 10.@12 ");
  EXPECT_EQ(joined("BOXES,,4 ,, .1"), "BOXES@1 <>@7 4@8 <>@11 .1@13 ");
  EXPECT_EQ(joined(",5"), "<>@1 5@2 ");
}

TEST(FreeField, IgnoresCommentsAndTrailingCommas) {
  EXPECT_EQ(joined("GRAVITY,0.,-9.8, $ down, at last"), "GRAVITY@1 0.@9 -9.8@12 ");
  EXPECT_EQ(joined("END!of it"), "END@1 ");
  EXPECT_EQ(joined(" \t! nothing"), "");
}

TEST(FreeField, NoticesACommaAtTheEndOfALine) {
  EXPECT_TRUE(split_fields("1., 2.,  $ more below", 1).comma);
  EXPECT_FALSE(split_fields("1., 2.", 1).comma);
}

TEST(FreeField, KeepsBlanksCommasAndDollarsInQuotes) {
  const Line line = split_fields("READ9, 'my $ mesh, 2.msh'", 1);
  ASSERT_EQ(line.fields.size(), 2U);
  EXPECT_EQ(line.fields[1].text, "my $ mesh, 2.msh");
  EXPECT_EQ(line.fields[1].where.length, 18);
}

// A field with faulty quotes contains the rest of the line.
TEST(FreeField, NoticesFaultyQuotes) {
  const Line open = split_fields("READ9, \"my mesh, 2.msh", 1);
  ASSERT_EQ(open.fields.size(), 2U);
  EXPECT_EQ(open.fields[1].fault, QuoteFault::not_closed);
  EXPECT_EQ(open.fields[1].where.length, 15);
  const Line more = split_fields("READ9, 'it's, mine'", 1);
  ASSERT_EQ(more.fields.size(), 2U);
  EXPECT_EQ(more.fields[1].fault, QuoteFault::text_after);
  for (const char* sound : {"READ9, 'a'", "READ9, 'a' , b", "READ9, 'a'$", "A 'b' 'c'",
                            "READ9, it's", "READ9, ''"})
    for (const Field& field : split_fields(sound, 1).fields)
      EXPECT_EQ(field.fault, QuoteFault::none) << sound;
}

// An accented letter has two bytes.
TEST(FreeField, CountsColumnsInCharacters) {
  EXPECT_EQ(joined("\xc3\xa9t\xc3\xa9, 1"), "\xc3\xa9t\xc3\xa9@1 1@6 ");
  EXPECT_EQ(joined("a\xe9z, 1"), "a?z@1 1@6 ");
}

TEST(FreeField, ReadsAllLineEndsAndIgnoresAByteOrderMark) {
  const std::vector<std::string> lines = {"a", "", "b", "c"};
  EXPECT_EQ(source_lines("a\n\nb\nc\n"), lines);
  EXPECT_EQ(source_lines("a\r\n\r\nb\r\nc"), lines);
  EXPECT_EQ(source_lines("\xef\xbb\xbf"
                         "a\r\rb\rc\r"),
            lines);
}

// Comment signs and keywords in the title have no meaning.
TEST(FreeField, ReadsTheTitleAfterStart) {
  const auto lines = split_deck("$ head\nstart 1 4\n  STOP $ here, 100 %  \r\nEND\n");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].title, "  STOP $ here, 100 %");
  EXPECT_EQ(lines[0].title_where.line, 3);
  EXPECT_EQ(lines[1].fields[0].where.line, 4);
}

TEST(FreeField, ReadsFortranNumbers) {
  EXPECT_EQ(read_number("1.D-3").value.value(), 1e-3);
  EXPECT_EQ(read_number("-.5e+01").value.value(), -5.0);
  EXPECT_EQ(read_number("+7.").value.value(), 7.0);
  EXPECT_EQ(read_number("1d0002").value.value(), 100.0);
  // The exponent may have no letter, and zero may have any exponent.
  const geometry::Decimal large = read_number("1.5+3").value;
  EXPECT_EQ(large.digits() + "e" + std::to_string(large.exponent()), "15e2");
  EXPECT_EQ(read_number("-1.5-3").value.value(), -1.5e-3);
  EXPECT_EQ(read_number("0.-999999999").fault, NumberFault::none);
}

TEST(FreeField, RefusesTextThatIsNoNumber) {
  for (const char* text : {"", ".", "+", "1e", "1.2.3", "--1", "0x10", "1f", "1e+",
                           "e5", "1,5", "1+", "1-2-3", "+-1", "1.5+e3",
                           "\xe2\x88\x92"
                           "1"}) {
    EXPECT_EQ(read_number(text).fault, NumberFault::not_a_number) << text;
  }
  for (const char* text :
       {"nan", "-INF", "Infinity", "1e400", "-1.d309", "1e9999999999"}) {
    EXPECT_EQ(read_number(text).fault, NumberFault::not_finite) << text;
  }
  for (const char* text : {"1e-999999999", "-2.D-500", "1-401"}) {
    EXPECT_EQ(read_number(text).fault, NumberFault::too_small) << text;
  }
}

// A list of values ends at the next card.
TEST(FreeField, DistinguishesValuesFromCards) {
  for (const char* text : {"1", "-1", "+.5", ".5", ",3", "nan", "-inf", "O.5",
                           "\xe2\x88\x92"
                           "9"}) {
    EXPECT_TRUE(split_fields(text, 1).is_data()) << text;
  }
  for (const char* text : {"END", "d5", "READ9", "x1", "'1'"}) {
    EXPECT_FALSE(split_fields(text, 1).is_data()) << text;
  }
}

}  // namespace
}  // namespace blocks::deck
