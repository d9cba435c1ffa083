#include "tools/program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

namespace blocks::testing {

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "blocks_run_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
}

Outcome blocks(const std::string& arguments, const fs::path& folder,
               const std::string& input) {
  const TemporaryFolder scratch;
  scratch.write("in", input);
  const std::string command =
      fmt::format("cd '{}' && {{ '{}' {}; }} <'{}' >'{}' 2>'{}'", folder.string(),
                  BLOCKS_PROGRAM, arguments, (scratch / "in").string(),
                  (scratch / "out").string(), (scratch / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(scratch / "out"),
          slurp(scratch / "err")};
}

int killed(const std::string& arguments, const std::string& awaited, double seconds,
           int signal, const fs::path& folder) {
  const std::string command =
      fmt::format("exec '{}' {} >/dev/null 2>&1 </dev/null", BLOCKS_PROGRAM, arguments);
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) == 0)
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  while (!fs::exists(folder / awaited) && waitpid(child, &status, WNOHANG) == 0)
    usleep(1000);
  usleep(static_cast<useconds_t>(seconds * 1e6));
  kill(child, signal);
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string slurp(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << "cannot read " << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

nlohmann::json summary(const TemporaryFolder& folder, const std::string& name) {
  return nlohmann::json::parse(slurp(folder / (name + ".summary.json")));
}

Outcome run_text(const TemporaryFolder& folder, const std::string& name,
                 const std::string& deck, const std::string& more) {
  folder.write(name + ".deck", deck);
  Outcome outcome = blocks("run " + name + ".deck " + more, folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome;
}

std::vector<fs::path> decks_below(const std::string& folder) {
  std::vector<fs::path> found;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(BLOCKS_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".deck")
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

namespace {

int count_cards(const std::string& deck, const std::string& name) {
  std::istringstream lines(deck);
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    count += line.substr(0, line.find_first_of(", \r")) == name;
  return count;
}

}  // namespace

bool has_card(const std::string& deck, const std::string& name) {
  return count_cards(deck, name) > 0;
}

std::string fewer_solves(const std::string& deck) {
  const int count = count_cards(deck, "SOLVE");
  std::string options;
  for (int i = 1; i <= count; ++i)
    options += count == 1 ? " --set SOLVE.nmax=40 "
                          : " --set 'SOLVE[" + std::to_string(i) + "].nmax=40' ";
  return options;
}

std::string preliminary(const std::string& more) {
  return "START, 100, 6\nA SMALL PROBLEM\nXLIMITS, -10, 10\nYLIMITS, -10, 10\n"
         "BOXES, 10, 10, 0.1\nSTIFF, 1.E7, 1.E7\nFRACTION, 0.02\n"
         "MATERIAL, 1, 1.E9, 4.E8, 1000\nMATERIAL, 2, 1.E9, 4.E8, 2000\n" +
         more + "END\n";
}

std::string rectangle(double left, double bottom, double right, double top,
                      bool fixed) {
  return fmt::format("CREATE, 4, 1, {}\n{}, {}, {}, {}\n{}, {}, {}, {}\n",
                     fixed ? 1 : 0, left, left, right, right, bottom, top, top, bottom);
}

std::string wall_at_random() {
  std::vector<std::string> bricks;
  for (int row = 0; row < 52; ++row)
    for (int i = 0; i < 80; ++i) {
      const double x = -8.0 + 0.2 * i, y = 0.15 * row, right = x + 0.2, top = y + 0.15;
      bricks.push_back(
          i % 3 != 0 ? rectangle(x, y, right, top)
                     : fmt::format("CREATE, 5, 1\n{}, {}, {}, {}, {}\n{}, {}, {}, "
                                   "{}, {}\n",
                                   x, x, right - 0.02, right, right, y, top, top,
                                   top - 0.02, y));
    }
  std::mt19937 random(1);
  for (std::size_t i = bricks.size(); i > 1; --i)
    std::swap(bricks[i - 1], bricks[random() % i]);
  std::string deck = preliminary() + rectangle(-9, -1, 9, 0, true);
  deck.replace(deck.find("100, 6"), 6, "5000, 6");
  deck.replace(deck.find("10, 0.1"), 7, "10, 0.02");
  for (const std::string& brick : bricks)
    deck += brick;
  return deck + rectangle(-9.5, 5, -9.3, 5.2) +
         "GRAVITY, 1, -9.81\nFRICTN, 0.5\nDAMPING, 0.3\n";
}

}  // namespace blocks::testing
