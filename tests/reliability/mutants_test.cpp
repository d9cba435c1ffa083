// Random changes of sound and faulty decks. Each mutant is refused with a message,
// runs, or ends as unsound. The test fails at a crash, a hang, an exception or a
// request for much memory.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include "reliability/deck_trial.hpp"
#include "tools/program.hpp"
#include "tools/sanitized.hpp"

namespace blocks::testing {
namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t n, Random& random) { return n == 0 ? 0 : random() % n; }

std::string one_of(std::initializer_list<const char*> words, Random& random) {
  return *(words.begin() + below(words.size(), random));
}

std::string value(Random& random) {
  return one_of({"",       "0",          "-1",          "1",
                 "2",      "3",          "1.5",         "NaN",
                 "-INF",   "1e400",      "-1D308",      "1e-320",
                 "1E12",   "2147483648", "-2147483649", "9007199254740993",
                 "1000",   "0.1",        "1e5",         "abc",
                 "'",      "''",         "1,2",         "$",
                 "RANDOM", "1e99999",    "-0",          "+.",
                 "\t"},
                random);
}

std::string keyword(Random& random) {
  return one_of({"START",    "XLIMITS", "BOXES",   "STIFF",  "FRACTION", "MATERIAL",
                 "FUNCTION", "RIGID",   "SEED",    "END",    "RESTART",  "CREATE",
                 "CLOOP",    "READ9",   "LAYER",   "ORIENT", "MERGE",    "SPLANE",
                 "GRAVITY",  "FIX",     "PRESSBC", "FORCE",  "FRICTN",   "SETVEL",
                 "SETVELM",  "DAMPING", "DUMP",    "OUTPUT", "PLOTS",    "MOTION",
                 "CYCLE",    "STOP"},
                random);
}

/// Returns the range [from, to) of a random value, word or line of the text.
std::pair<std::size_t, std::size_t> piece(const std::string& text, const char* ends,
                                          Random& random) {
  const std::size_t at = below(text.size(), random);
  const std::size_t from = text.find_last_of(ends, at == 0 ? 0 : at - 1);
  const std::size_t to = text.find_first_of(ends, at);
  return {from == std::string::npos || from >= at ? at : from + 1,
          to == std::string::npos ? text.size() : to};
}

void mutate(std::string& text, const std::vector<std::string>& decks, Random& random) {
  const auto [line, line_end] = piece(text, "\n", random);
  const auto [field, field_end] = piece(text, ",\n", random);
  const std::size_t at = below(text.size(), random);
  const std::string whole_line = text.substr(line, line_end - line);
  switch (random() % 13) {
  case 0:
  case 1:
  case 2:
  case 3:
    text.replace(field, field_end - field, value(random));
    break;
  case 4:
    text.erase(line, line_end - line + 1);
    break;
  case 5:
    text.insert(line, whole_line + "\n");
    break;
  case 6: {
    text.erase(line, line_end - line + 1);
    const std::size_t there = piece(text, "\n", random).first;
    text.insert(std::min(there, text.size()), whole_line + "\n");
    break;
  }
  case 7:
    text.insert(line,
                keyword(random) + ", " + value(random) + ", " + value(random) + "\n");
    break;
  case 8:
    text.insert(at, 1, static_cast<char>(random() % 256));
    break;
  case 9:
    text.erase(at, 1 + below(4, random));
    break;
  case 10:
    text.resize(at);
    break;
  case 11: {
    const std::string& other = decks[below(decks.size(), random)];
    const auto [from, to] = piece(other, "\n", random);
    text.insert(line, other.substr(from, to - from) + "\n");
    break;
  }
  default:
    text.insert(field, value(random) + ",");
  }
}

/// The mutant under test, for the signal handler.
std::string tried;

void hang(int) {
  constexpr char said[] = "\nthis deck takes longer than a minute:\n";
  if (write(2, said, sizeof said - 1) < 0 || write(2, tried.data(), tried.size()) < 0)
    _exit(3);
  _exit(2);
}

TEST(Mutants, AreRefusedOrRun) {
  const bool all = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const long mutants = all ? 100000 : 1500;
  std::vector<std::string> decks;
  for (const char* folder : {"decks", "tests/corpus"})
    for (const fs::path& path : decks_below(folder))
      if (fs::file_size(path) < 20000)
        decks.push_back(slurp(path));
  ASSERT_GE(decks.size(), 70U);
  const std::size_t sound = decks_below("decks").size();  // Sound decks are first.
  const std::string meshes =
      (fs::path(BLOCKS_SOURCE_DIR) / "decks/every_card").string();
#ifndef BLOCKS_SANITIZED
  rlimit memory{};
  getrlimit(RLIMIT_AS, &memory);
  const rlimit small{rlim_t{4} << 30, memory.rlim_max};
  setrlimit(RLIMIT_AS, &small);
#endif
  std::signal(SIGALRM, hang);
  std::map<Verdict, long> verdicts;
  for (long i = 0; i < mutants; ++i) {
    Random random(static_cast<unsigned long>(i));
    tried = decks[i % 2 == 0 ? below(sound, random) : below(decks.size(), random)];
    const std::size_t changes = 1 + below(i % 2 == 0 ? 2 : 4, random);
    for (std::size_t k = 0; k < changes && !tried.empty(); ++k)
      mutate(tried, decks, random);
    alarm(60);
    try {
      ++verdicts[try_deck(tried, meshes, 3)];
    } catch (const std::exception& fault) {
      ADD_FAILURE() << "mutant " << i << ": " << fault.what() << "\n" << tried;
    }
  }
  alarm(0);
#ifndef BLOCKS_SANITIZED
  setrlimit(RLIMIT_AS, &memory);
#endif
  RecordProperty("tried", std::to_string(mutants));
  RecordProperty("refused", std::to_string(verdicts[Verdict::refused]));
  RecordProperty("ran", std::to_string(verdicts[Verdict::ran]));
  RecordProperty("unsound", std::to_string(verdicts[Verdict::unsound]));
  EXPECT_GT(verdicts[Verdict::ran], mutants / 20);
  EXPECT_GT(verdicts[Verdict::refused], mutants / 4);
}

}  // namespace
}  // namespace blocks::testing
