#include "deck/parser.hpp"

#include <fmt/format.h>

#include <cctype>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "deck/cards/settable.hpp"
#include "deck_test_tools.hpp"

namespace blocks::deck {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A deck in the style of 1982: capitals, D exponents, no blanks, lists over several
// cards.
const std::string deck_of_1982 = R"(START,100,4
CRATER IN OIL SHALE, HALF MODEL $ NOT A COMMENT
XLIMITS,0.,100.
YLIMITS,-1.D1,40.
BOXES,20,10
STIFF,1.D7,
FRACTION,.05
MATERIAL,1,2.D10,8.D9,2300.
FUNCTION,3
0.,0.
1.D-3,1.
5.D-3,0.
END
GRAVITY,0.,-9.8
CREATE,4,1,1
0.,0.,
10.,10.
0.,1.,
1.,0.
LAYER,4,1,0.,2.,0.,3.,
8.,3.,8.,2.
1.,2.,2.,3.
2.
LAYER,-12,1,0.,3.,0.,5.,30.,5.,30.,3.,RANDOM
PRESSBC,1,2,1.D6,1.D6,
OUTPUT,.1,1,2
MOTION,.5
STOP
)";

TEST(Parser, ReadsADeckOf1982Unmodified) {
  const Parsed p = parse_text(deck_of_1982);
  EXPECT_EQ(p.messages, "");
  std::string names;
  for (const Command& command : p.deck.commands) {
    names += command.name + " ";
  }
  EXPECT_EQ(names, "START XLIMITS YLIMITS BOXES STIFF FRACTION MATERIAL FUNCTION END "
                   "GRAVITY CREATE LAYER LAYER PRESSBC OUTPUT MOTION STOP ");
  EXPECT_EQ(p.only<Start>().title, "CRATER IN OIL SHALE, HALF MODEL $ NOT A COMMENT");
  EXPECT_EQ(p.only<Create>().y[1].value.value(), 1.0);
  EXPECT_EQ(p.only<Create>().y[1].where.line, 18);
}

TEST(Parser, IgnoresLineEndsAndLetterCase) {
  std::string windows = "\xef\xbb\xbf";
  std::string small;
  for (const char c : deck_of_1982) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    small += static_cast<char>(std::tolower(c));
  }
  const std::size_t count = parse_text(deck_of_1982).deck.commands.size();
  for (const std::string& text : {windows, small}) {
    const Parsed p = parse_text(text);
    EXPECT_EQ(p.messages, "");
    EXPECT_EQ(p.deck.commands.size(), count);
    EXPECT_EQ(p.only<Layer>().rcommand.value, "RANDOM");
    EXPECT_EQ(p.only<Motion>().dt.where.line, 27);
  }
}

TEST(Parser, EndOfFileActsAsStop) {
  EXPECT_EQ(parse_text(preliminary_cards + "CYCLE, 1").messages, "");
}

TEST(Overrides, ReplaceAFieldOfEveryCardOfThatName) {
  const Parsed p = parse_text(
      preliminary_cards + "MOTION, 1\nMOTION, 2\nOUTPUT, 1, 4\n",
      {{"motion", "DT", "3.D0"}, {"BOXES", "ctol", ".5"}, {"OUTPUT", "nb", "1,2"}});
  EXPECT_EQ(p.messages, "");
  EXPECT_EQ(std::get<Motion>(p.deck.commands[7].card).dt.value, 3.0);
  EXPECT_EQ(std::get<Motion>(p.deck.commands[8].card).dt.value, 3.0);
  EXPECT_EQ(p.only<Boxes>().ctol.value, 0.5);
  EXPECT_TRUE(p.only<Boxes>().ctol.given);
  EXPECT_EQ(p.only<Boxes>().ctol.where.line, 0);
  EXPECT_EQ(p.only<Output>().blocks.size(), 2U);
}

TEST(Overrides, WithANumberReplaceAFieldOfOneCard) {
  const Parsed p = parse_text(preliminary_cards + "MOTION, 1\nMOTION, 2\nMOTION, 3\n",
                              {{"MOTION", "dt", "4"}, {"motion[2]", "dt", "5"}});
  EXPECT_EQ(p.messages, "");
  EXPECT_EQ(std::get<Motion>(p.deck.commands[7].card).dt.value, 4.0);
  EXPECT_EQ(std::get<Motion>(p.deck.commands[8].card).dt.value, 5.0);
  EXPECT_EQ(std::get<Motion>(p.deck.commands[9].card).dt.value, 4.0);
}

TEST(Overrides, TellHowManyCardsThereAre) {
  EXPECT_EQ(
      parse_text(preliminary_cards + "MOTION, 1\nMOTION, 2\nSTOP\nMOTION, 3\n",
                 {{"MOTION[3]", "dt", "1"},
                  {"MOTION[0]", "dt", "1"},
                  {"MOTION[x", "dt", "1"},
                  {"BOXES[2]", "ctol", "1"}})
          .messages,
      "--set MOTION[3].dt=1: error: MOTION: the deck has 2 MOTION cards, no "
      "MOTION[3]\n  hint: write MOTION[1] to [2]; blocks cards --set DECK lists "
      "what can be set\n--set MOTION[0].dt=1: error: MOTION: there is no card "
      "'MOTION[0]'\n  hint: MOTION[1] is the first MOTION of the deck\n--set "
      "MOTION[x.dt=1: error: MOTION: there is no card 'MOTION[x'\n  hint: "
      "MOTION[1] is the first MOTION of the deck\n--set BOXES[2].ctol=1: error: "
      "BOXES: the deck has 1 BOXES card, no BOXES[2]\n  hint: write BOXES; blocks "
      "cards --set DECK lists what can be set\nt.deck:12:1: warning: STOP: text "
      "after STOP is ignored\n  MOTION, 3\n  ^~~~~~\n4 errors, 1 warning\n");
}

TEST(SettableFields, HaveTheFormOfOverrides) {
  EXPECT_THAT(settable_fields("RESTART, 'my run.h5'\nMOTION, 1.D-1 $ comment\n"
                              "OUTPUT, 1, 4,\n5\nLAYER, 2, 1, 0,0, 0,1,\n1,1, 1,0\n"
                              "1,1\nmotion 2\nSTOP\nMOTION, 3\n"),
              ElementsAre("RESTART.file='my run.h5'", "MOTION[1].dt=1.D-1",
                          "OUTPUT.dtout=1", "OUTPUT.nb=4,5", "LAYER.ns=2",
                          "LAYER.mat=1", "LAYER.x1=0", "LAYER.y1=0", "LAYER.x2=0",
                          "LAYER.y2=1", "LAYER.x3=1", "LAYER.y3=1", "LAYER.x4=1",
                          "LAYER.y4=0", "LAYER.rcommand=", "LAYER.jbot=0",
                          "LAYER.jtop=0", "LAYER.jside=0", "MOTION[2].dt=2"));
  EXPECT_THAT(settable_fields("READ9, \"'tis\"\n"),
              ElementsAre("READ9.file=\"'tis\"", "READ9.jbot=0", "READ9.jtop=0",
                          "READ9.jside=0"));
}

TEST(Overrides, MayReplaceAValueOutOfRange) {
  EXPECT_EQ(
      parse_text(preliminary_cards + "MOTION, -1\n", {{"MOTION", "dt", "1"}}).messages,
      "");
}

TEST(Overrides, AreCheckedLikeTheDeck) {
  EXPECT_EQ(
      parse_text(preliminary_cards + "MOTION, 1\nMOTION, 2\n", {{"MOTION", "dt", "-1"},
                                                                {"MOTOIN", "dt", "1"},
                                                                {"MOTION", "td", "1"},
                                                                {"DUMP", "x", "1"},
                                                                {"FIX", "nb2", "1"},
                                                                {"SEED", "seed", "5"}})
          .messages,
      "--set MOTION.dt=-1: error: MOTION: dt must be > 0, found '-1'\n  hint: dt: "
      "interval\n--set MOTOIN.dt=1: error: unknown card 'MOTOIN'\n  hint: did you mean "
      "MOTION?\n--set MOTION.td=1: error: MOTION: unknown field 'td'\n  hint: did you "
      "mean dt?\n--set DUMP.x=1: error: DUMP: unknown field 'x'\n  hint: this card has "
      "no fields\n--set FIX.nb2=1: error: FIX: unknown field 'nb2'\n  hint: its only "
      "field is nblok\n--set SEED.seed=5: error: SEED: the deck has no such card, so "
      "--set "
      "cannot change it\n  hint: add the card to the deck\n6 errors\n");
}

// Most lines of such a deck end between columns 73 and 80.
TEST(Parser, LongCoordinatesAreNoSequenceNumbers) {
  std::string text = preliminary_cards;
  for (int i = 0; i < 40; ++i) {
    const double x = 1.0 + 0.61803398874989485 * i, y = 0.0123456789012345678 * i;
    text += fmt::format("CREATE, 4, 1\n{0:.16f}, {0:.16f}, {1:.16f}, {1:.16f}\n", x,
                        x + 0.31415926535897931);
    text += fmt::format("{0:.17f}, {1:.17f}, {1:.17f}, {0:.17f}\n", y,
                        y + 0.27182818284590452);
  }
  EXPECT_EQ(parse_text(text + "CYCLE, 1\n").messages, "");
}

// The value of --set has no comments, and a word needs no quotes.
TEST(Overrides, TakeWordsAsTheyAre) {
  for (const char* name : {"a!b$c", "soft rock", "  wet, clay ", "'soft rock'"}) {
    const Parsed p =
        parse_text(preliminary_cards + "CYCLE, 1\n", {{"MATERIAL", "name", name}});
    EXPECT_EQ(p.messages, "") << name;
    std::string expected = name;
    std::erase(expected, '\'');
    expected = expected.substr(expected.find_first_not_of(' '));
    expected.erase(expected.find_last_not_of(' ') + 1);
    EXPECT_EQ(p.only<Material>().name.value, expected);
  }
  EXPECT_THAT(
      parse_text(preliminary_cards + "MOTION, 1\n", {{"MOTION", "dt", ".3 $ hello"},
                                                     {"BOXES", "ctol", "\xff"},
                                                     {"MATERIAL", "name", "a\nRIGID"}})
          .messages,
      AllOf(HasSubstr("MATERIAL: the value has a control character"),
            HasSubstr("dt, found '.3 $ hello'"),
            HasSubstr("BOXES: the value is not in UTF-8")));
}

TEST(Overrides, ChangeTheLengthOfListsTheyCount) {
  const std::string text = preliminary_cards + "CREATE, 4, 1\n0,1,1\n0,1,0\n";
  EXPECT_EQ(parse_text(text, {{"CREATE", "nc", "3"}}).messages, "");
}

TEST(Diagnostics, PrintAtMostAHundredMessages) {
  std::string text = preliminary_cards;
  for (int i = 0; i < 105; ++i) {
    text += "NONSENSE\n";
  }
  EXPECT_THAT(parse_text(text).messages,
              HasSubstr("\n... and 5 more not shown\n105 errors\n"));
}

TEST(Diagnostics, AreSortedByPlaceAndCounted) {
  Diagnostics d("a.deck", "one\n\ttwo\n");
  d.warning({2, 2, 3}, "CARD", "late");
  d.error({1, 1, 3}, "", "early", "try harder");
  EXPECT_EQ(d.format_all(), "a.deck:1:1: error: early\n"
                            "  one\n"
                            "  ^~~\n"
                            "  hint: try harder\n"
                            "a.deck:2:2: warning: CARD: late\n"
                            "          two\n"
                            "          ^~~\n"
                            "1 error, 1 warning\n");
  EXPECT_TRUE(d.has_errors());
  EXPECT_EQ(Diagnostics("b", "").format_all(), "");
}

}  // namespace
}  // namespace blocks::deck
