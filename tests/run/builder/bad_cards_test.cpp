// Messages about faulty cards. A file tests/corpus/bad_cards/CARD.txt has cases of
// base.deck with one faulty card. A case consists of "== name", the lines that replace
// the card, "--", and the messages.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "deck/cards/card_table.hpp"
#include "deck/free_field.hpp"
#include "run/run.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

const fs::path corpus = fs::path(BLOCKS_SOURCE_DIR) / "tests/corpus/bad_cards";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

struct BadCard {
  std::string name, text, expected;
};

/// Reads the cases of a file.
std::vector<BadCard> cases_of(const fs::path& file) {
  std::vector<BadCard> cases;
  bool in_messages = false;
  for (const std::string& line : lines_of(slurp(file))) {
    if (line.starts_with("== ")) {
      cases.push_back({line.substr(3), "", ""});
      in_messages = false;
    } else if (line == "--") {
      in_messages = true;
    } else {
      (in_messages ? cases.back().expected : cases.back().text) += line + "\n";
    }
  }
  return cases;
}

bool is_card(const std::string& line) {
  return deck::find_card(line.substr(0, line.find(','))) != nullptr;
}

/// Returns the sound deck with the last card of that name and its lists replaced by
/// `text`. If it has no such card, the text replaces DUMP.
std::string with_fault(const std::string& card, const std::string& text) {
  const std::vector<std::string> lines = lines_of(slurp(corpus / "base.deck"));
  const auto last = [&](const std::string& name) {
    std::size_t at = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].substr(0, lines[i].find(',')) == name)
        at = i;
    return at;
  };
  std::size_t from = last(card);
  if (from == lines.size())
    from = last("DUMP");
  std::size_t to = from + 1;
  while (to < lines.size() && !is_card(lines[to]))
    ++to;
  std::string deck;
  for (std::size_t i = 0; i < from; ++i)
    deck += lines[i] + "\n";
  deck += text;
  for (std::size_t i = to; i < lines.size(); ++i)
    deck += lines[i] + "\n";
  return deck;
}

std::vector<fs::path> files() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(corpus))
    if (entry.path().extension() == ".txt")
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

class BadCards : public ::testing::TestWithParam<fs::path> {
 protected:
  // Messages have the name of the deck as it was given.
  void SetUp() override { fs::current_path(folder_.path()); }
  void TearDown() override { fs::current_path(fs::temp_directory_path()); }
  std::string messages_about(const std::string& deck, bool& sound) {
    folder_.write("deck", deck);
    run::RunOptions options;
    options.deck = "deck";
    ::testing::internal::CaptureStderr();
    sound = run::build_checked(options).code == run::done;
    return ::testing::internal::GetCapturedStderr();
  }
  TemporaryFolder folder_;
};

// Fields are missing, surplus, out of range, not numbers or not finite, or name
// something that does not exist.
TEST_P(BadCards, GetExactlyTheseDiagnostics) {
  for (const BadCard& one : cases_of(GetParam())) {
    bool sound = true;
    EXPECT_EQ(messages_about(with_fault(GetParam().stem().string(), one.text), sound),
              one.expected)
        << one.name;
    EXPECT_FALSE(sound) << one.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadCards, ::testing::ValuesIn(files()),
                         [](const auto& one) { return one.param.stem().string(); });

TEST(BadCardsCorpus, HasEveryCardAndNoCaseTwice) {
  std::size_t count = 0;
  std::set<std::string> cards;
  for (const fs::path& file : files()) {
    cards.insert(file.stem().string());
    std::set<std::string> names;
    for (const BadCard& one : cases_of(file))
      EXPECT_TRUE(names.insert(one.name).second) << file << one.name;
    count += names.size();
  }
  for (const std::string_view card : deck::card_names())
    EXPECT_TRUE(cards.contains(std::string(card))) << card;
  RecordProperty("decks", std::to_string(count));
  EXPECT_GE(count, 500U);
}

TEST(BadCardsCorpus, HasASoundBaseDeck) {
  EXPECT_EQ(blocks("check '" + (corpus / "base.deck").string() + "'", "/tmp").code, 0);
}

}  // namespace
}  // namespace blocks::testing
