#include "deck/cards/cards_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "deck/cards/card_table.hpp"
#include "deck/cut_group.hpp"
#include "deck_test_tools.hpp"

namespace blocks::deck {
namespace {

using testing::HasSubstr;

TEST(CardsText, HasExamplesThatParse) {
  for (const CardSpec& card : card_table()) {
    std::string text = preliminary_cards;
    const std::string example(card.example);
    const auto replace = [&](const std::string& line) {
      text.replace(text.find(line), line.size(), example + "\n");
    };
    if (card.name == "RESTART") {
      text = example;
    } else if (card.name == "START") {
      replace("START, 100, 6\nTitle\n");
    } else if (CutGroup::has(card.name)) {  // its group, in which CUT follows
      const auto example_of = [](std::string_view name) {
        return std::string(find_card(name)->example) + "\n";
      };
      if (card.name == "OUTLINE") {
        text += example + "\n" + example_of("JSET");
      } else {
        text += example_of("OUTLINE") + example_of("JSET") + example + "\n";
      }
      text += card.name == "CUT" ? "" : example_of("CUT");
    } else if (card.group == CardGroup::problem) {
      text += example;
    } else {
      const auto at = text.find("\n" + std::string(card.name)) + 1;
      if (at > 0) {
        text.erase(at, text.find('\n', at) + 1 - at);
      }
      text.insert(card.name == "END" ? text.size() : text.find("END"), example + "\n");
    }
    EXPECT_EQ(parse_text(text).messages, "") << text;
  }
}

TEST(CardsText, ListsEveryCardAndHasAPageForEach) {
  const std::string all = all_cards();
  const std::string markdown = card_reference_markdown();
  for (const CardSpec& card : card_table()) {
    EXPECT_THAT(all, HasSubstr("\n  " + std::string(card.name) + " "));
    EXPECT_THAT(markdown, HasSubstr("\n### " + std::string(card.name) + "\n"));
    ASSERT_TRUE(card_page(card.name).has_value());
    EXPECT_THAT(*card_page(card.name), HasSubstr(std::string(card.summary.substr(1))));
  }
}

TEST(CardsText, ShowsSyntaxDefaultsAndRangesOfACard) {
  const std::string page = card_page("boxes").value();
  EXPECT_EQ(page.substr(0, page.find('\n')), "BOXES, iboxes, jboxes, ctol");
  EXPECT_THAT(page, HasSubstr("iboxes  whole  required  >= 1   [-]\n"));
  EXPECT_THAT(page, HasSubstr("ctol    real   0.1       > 0    [L]\n"));
  EXPECT_FALSE(card_page("BOX").has_value());
}

TEST(CardsText, SuggestsTheNearestName) {
  EXPECT_EQ(suggest_card("gravty"), "GRAVITY");
  EXPECT_EQ(suggest_card("FRICTION"), "FRICTN");
  EXPECT_EQ(suggest_card("SETVLEM"), "SETVELM");
  EXPECT_EQ(suggest_card("PRESS"), "PRESSBC");
  EXPECT_EQ(suggest_card("EDN"), "END");
  EXPECT_EQ(suggest_card("LAYR"), "LAYER");
  EXPECT_EQ(suggest_card("WIND"), "");
  EXPECT_EQ(suggest_card(std::string(100000, 'A')), "");
}

// DUMP is fewer edits away than DAMPING.
TEST(CardsText, SuggestsANameThatBeginsWithTheWordFirst) {
  EXPECT_EQ(suggest_card("DAMP"), "DAMPING");
  EXPECT_EQ(suggest_card("SETVE"), "SETVEL");
  EXPECT_EQ(suggest_card("RES"), "RESTART");
  EXPECT_EQ(suggest_card("STAR"), "START");
}

}  // namespace
}  // namespace blocks::deck
