// The diagnostics of tests/corpus/bad/NAME.deck are those of NAME.expected.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "deck/parser.hpp"

namespace blocks::deck {
namespace {

std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<std::filesystem::path> bad_decks() {
  std::vector<std::filesystem::path> out;
  const auto folder = std::filesystem::path(BLOCKS_SOURCE_DIR) / "tests/corpus/bad";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".deck") {
      out.push_back(entry.path());
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

class BadDeck : public testing::TestWithParam<std::filesystem::path> {};

// Each fault has one message, and no fault hides another.
TEST_P(BadDeck, GetsExactlyTheseDiagnostics) {
  auto expected = GetParam();
  expected.replace_extension(".expected");
  const std::string name = GetParam().filename().string();
  const std::string text = slurp(GetParam());
  Diagnostics diagnostics(name, text);
  parse(name, text, diagnostics);
  EXPECT_EQ(diagnostics.format_all(), slurp(expected));
  EXPECT_TRUE(diagnostics.has_errors());
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadDeck, testing::ValuesIn(bad_decks()),
                         [](const auto& one) { return one.param.stem().string(); });

// Without decks the test above would pass.
TEST(BadDecks, AreFound) { EXPECT_GE(bad_decks().size(), 40U); }

}  // namespace
}  // namespace blocks::deck
