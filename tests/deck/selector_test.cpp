// Selectors: how a field with brackets is split, read and refused.
#include "deck/selector.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "deck/free_field.hpp"
#include "deck_test_tools.hpp"

namespace blocks::deck {
namespace {

using ::testing::HasSubstr;
using By = Selector::By;

// Commas and blanks within the brackets of a selector separate its values, not fields.
TEST(Selector, IsOneField) {
  const Line line = split_fields("SETVEL, at( 1.5, -2 ), , 3 $ to the right", 1);
  ASSERT_EQ(line.fields.size(), 4U);
  EXPECT_EQ(line.fields[1].text, "at( 1.5, -2 )");
  EXPECT_EQ(line.fields[1].where.column, 9);
  EXPECT_EQ(line.fields[1].where.length, 13);
  EXPECT_EQ(line.fields[3].text, "3");
  const Line history = split_fields("HISTORY .1 y:in(0 0 4 5):max, ke", 1);
  ASSERT_EQ(history.fields.size(), 4U);
  EXPECT_EQ(history.fields[2].text, "y:in(0 0 4 5):max");
}

// Other brackets are text as before: only the names of selectors open them.
TEST(Selector, LeavesOtherBracketsAlone) {
  EXPECT_EQ(split_fields("READ9, mesh(1,2).txt", 1).fields.size(), 3U);
}

TEST(Selector, HasItsValuesAsWritten) {
  const Parsed parsed = parse_text(
      preliminary_cards + "FIX, AT(.1, 2.D-1)\nFREE, material('old stone')\n"
                          "PRESSBC, , edge(3), 1, 2\nOUTPUT, 1, 4,\nin(0 1 2 3), 7\n"
                          "CYCLE, 1\n");
  EXPECT_EQ(parsed.messages.find("error"), std::string::npos) << parsed.messages;
  const Selector at = *parsed.only<Fix>().nblok.selector;
  EXPECT_EQ(at.by, By::at);
  EXPECT_EQ(at.numbers[0].value(), 0.1);
  EXPECT_EQ(at.numbers[1].value(), 0.2);
  EXPECT_EQ(parsed.only<Free>().blocks.nb1.selector->material, "old stone");
  EXPECT_EQ(parsed.only<PressBc>().nside.selector->by, By::edge);
  EXPECT_FALSE(parsed.only<PressBc>().nblok.given());
  const std::vector<NumberOrSelector>& printed = parsed.only<Output>().blocks;
  ASSERT_EQ(printed.size(), 3U);
  EXPECT_EQ(printed[0].number.value, 4);
  EXPECT_EQ(printed[1].selector->text, "in(0 1 2 3)");
  EXPECT_EQ(printed[2].number.value, 7);
}

TEST(Selector, IsSetFromTheCommandLine) {
  const Parsed parsed = parse_text(preliminary_cards + "FIX, 3\nCYCLE, 1\n",
                                   {{"FIX", "nblok", "at(1, 2)"}});
  EXPECT_EQ(parsed.only<Fix>().nblok.selector->text, "at(1, 2)") << parsed.messages;
}

// Each message points at the part that is wrong.
TEST(Selector, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> faults[] = {
      {"FIX, at(1)", "t.deck:9:8: error: FIX: at takes 2 values, found 1\n"},
      {"FIX, at(1, a)",
       "t.deck:9:12: error: FIX: expected a number in at, found 'a'\n"},
      {"FIX, at (1, 2)", "t.deck:9:6: error: FIX: the values of 'at' are missing\n"},
      {"PRESSBC, , on(1, 2, 1, 2), 1, 1",
       "t.deck:9:14: error: PRESSBC: both points of the line are the same\n"},
      {"FIX, at(1, 2", "t.deck:9:8: error: FIX: the bracket is not closed\n"},
      {"FIX, at(1, 2)3",
       "t.deck:9:14: error: FIX: there is text after the closing bracket\n"},
      {"FIX, att(1)", "t.deck:9:6: error: FIX: there is no selector 'att'\n"},
      {"FIX, joint(2)",
       "t.deck:9:6: error: FIX: joint(2) does not name blocks for nblok\n"},
      {"PRESSBC, 1, joint(0), 1, 1",
       "t.deck:9:19: error: PRESSBC: expected a whole number from 1 in joint"},
      {"PRESSBC, , 2, 1, 1",
       "t.deck:9:12: error: PRESSBC: a side without a block: nblok is missing\n"},
      {"REMOVE, in(0, 0, 1, 1), 4",
       "t.deck:9:25: error: REMOVE: nb2 has no meaning after a selector\n"},
      {"REMOVE, 1, , , , CENTROID",
       "t.deck:9:18: error: REMOVE: a rule without an outline\n"}};
  for (const auto& [card, message] : faults)
    EXPECT_THAT(parse_text(preliminary_cards + card + "\nCYCLE, 1\n").messages,
                HasSubstr(message));
}

}  // namespace
}  // namespace blocks::deck
