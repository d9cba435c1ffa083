// Decks that are no text, have one long line, or need more memory than any machine has.
// The message is short, and the program needs little memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>

#include "tools/program.hpp"
#include "tools/sanitized.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// Runs the program with half a gigabyte of memory.
Outcome run_small(const TemporaryFolder& folder, const std::string& deck) {
  folder.write("a.deck", deck);
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
#ifndef BLOCKS_SANITIZED
  const rlimit small{rlim_t{512} << 20, before.rlim_max};
  setrlimit(RLIMIT_AS, &small);
#endif
  Outcome run = blocks("run a.deck -q", folder.path());
  setrlimit(RLIMIT_AS, &before);
  return run;
}

const std::string sound =
    preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\nCYCLE, 5\n";

void expect_refused(const std::string& deck, const std::string& message) {
  const TemporaryFolder folder;
  const Outcome run = run_small(folder, deck);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr(message));
  EXPECT_LT(run.err.size(), 5000U);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1)
      << "a refused deck leaves no file";
}

std::string with(const std::string& from, const std::string& to) {
  std::string deck = sound;
  return deck.replace(deck.find(from), from.size(), to);
}

TEST(WholeFile, MayHaveTheLineEndsOfAnySystem) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_small(folder, sound).code, 0);
  const auto hash = summary(folder, "a")["state_hash"];
  std::string crlf, cr;
  for (const char c : sound) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  for (const std::string& deck :
       {"\xef\xbb\xbf" + sound, crlf, cr, "\n\n" + sound, sound + "\x1a"}) {
    ASSERT_EQ(run_small(folder, deck).code, 0);
    EXPECT_EQ(summary(folder, "a")["state_hash"], hash);
  }
}

TEST(WholeFile, IsRefusedIfItIsNoText) {
  expect_refused("", "a.deck:1:1: error: the deck is empty");
  expect_refused("\n\n\n", "a.deck:1:1: error: the deck is empty");
  expect_refused(with("GRAVITY", std::string("GRA\0ITY", 7)),
                 "a.deck:15:4: error: not a text file");
  expect_refused("\x7f"
                 "ELF" +
                     std::string(1 << 20, '\1'),
                 "not a text file");
}

// The command of the hint makes a sound deck.
TEST(WholeFile, IsRefusedWithTheConversionIfItIsUtf16OrUtf32) {
  using namespace std::string_literals;
  std::string little, big, little_32, big_32;
  for (const char c : sound) {
    little += {c, '\0'};
    big += {'\0', c};
    little_32 += {c, '\0', '\0', '\0'};
    big_32 += {'\0', '\0', '\0', c};
  }
  const std::pair<std::string, std::string> decks[] = {
      {"UTF-16", "\xff\xfe" + little},
      {"UTF-16", "\xfe\xff" + big},
      {"UTF-16LE", little},
      {"UTF-16BE", big},
      {"UTF-32", "\xff\xfe\0\0"s + little_32},
      {"UTF-32", "\0\0\xfe\xff"s + big_32},
      {"UTF-32LE", little_32},
      {"UTF-32BE", big_32}};
  for (const auto& [kind, deck] : decks) {
    expect_refused(deck, "a.deck:1:1: error: the deck is stored as " +
                             kind.substr(0, 6) + "\n");
    expect_refused(deck, "\n  hint: save it as UTF-8, or convert it with iconv -f " +
                             kind + " -t UTF-8 OLD.deck >NEW.deck\n1 error\n");
    const TemporaryFolder folder;
    folder.write("old.deck", deck);
    const Outcome run =
        blocks("--version >/dev/null; iconv -f " + kind +
                   " -t UTF-8 old.deck >new.deck; '" BLOCKS_PROGRAM "' check new.deck",
               folder.path());
    EXPECT_EQ(run.code, 0) << kind << run.err;
  }
}

TEST(WholeFile, IsRefusedWithAShortMessageIfItHasALongLine) {
  const std::size_t size = 10 << 20;
  const std::string words = "bytes, a line of a deck at most 1000000";
  expect_refused(std::string(size, 'A'),
                 "a.deck:1:1: error: the line has 10485760 " + words);
  expect_refused(with("0, -10", "0, -10" + std::string(size, ' ') + "x"),
                 "a.deck:15:1: error: the line has 10485776 " + words);
  std::string commas;
  for (std::size_t i = 0; i < 400000; ++i)
    commas += "1,";
  expect_refused(with("0, -10", "0, -10, " + commas),
                 "a.deck:15:20: error: GRAVITY: one value too many");
}

// These are as many as fit into a line.
TEST(WholeFile, NeedsLittleMemoryForALongOutputCard) {
  const TemporaryFolder folder;
  std::string ones = "OUTPUT, 1";
  for (int i = 0; i < 300000; ++i)
    ones += ", 1";
  EXPECT_EQ(run_small(folder, with("GRAVITY", ones + "\nGRAVITY")).code, 0);
}

// The deck is refused before memory is requested.
TEST(WholeFile, IsRefusedIfItNeedsTooMuchMemory) {
  const auto blocks_of = [](const std::string& card) {
    return with("START, 100, 6", "START, 2000000000, 6") + card;
  };
  expect_refused(
      blocks_of("CLOOP, 1000000000000, 1, 0\n" + rectangle(2, 0, 3, 1) + "CYCLE, 1\n"),
      "CLOOP");
  expect_refused(
      blocks_of("CLOOP, 1900000000, 0, 0\n" + rectangle(2, 0, 3, 1) + "CYCLE, 1\n"),
      "one card may make 20000000 blocks at most");
  expect_refused(blocks_of("LAYER, -1900000000, 1, 2,0, 2,1, 9,1, 9,0\nCYCLE, 1\n"),
                 "ns must be");
  expect_refused(blocks_of("LAYER, 1000000000000, 1, 2,0, 2,1, 9,1, 9,0\n"), "LAYER");
  expect_refused(with("BOXES, 10, 10", "BOXES, 1000000000000, 1000000000000"), "BOXES");
  std::string row = with("START, 100, 6", "START, 50000, 6");
  row.replace(row.find("BOXES, 10, 10, 0.1"), 18, "BOXES, 10, 10, 1e6");
  row.insert(row.find("GRAVITY"), "CLOOP, 30000, 2, 0\n" + rectangle(2, 0, 3, 1));
  expect_refused(
      row, "BOXES: with ctol = 1e+06 about 4.5e+08 pairs of blocks are near each");
  expect_refused(with("BOXES, 10, 10", "BOXES, 100000, 100000"), "too many boxes");
  expect_refused(preliminary("RIGID\nFUNCTION, 1000000000000\n0, 1\n") +
                     rectangle(0, 0, 1, 1) + "CYCLE, 1\n",
                 "FUNCTION");
  expect_refused(with("CREATE, 4", "CREATE, 1000000000000"), "CREATE");
}

}  // namespace
}  // namespace blocks::testing
