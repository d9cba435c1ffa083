// The help of every command gives its purpose, its usage, and an example that works in
// this repository.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    found.push_back(line);
  return found;
}

/// Returns the names of all commands.
std::vector<std::string> commands(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  bool listed = false;
  for (const std::string& line : lines(blocks("--help", folder.path()).out)) {
    if (listed && line.starts_with("  "))
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    listed = listed || line == "Subcommands:";
  }
  return names;
}

/// Runs a line of the help and returns its exit code.
int run_line(const std::string& line, const TemporaryFolder& folder) {
  const std::string program_folder =
      std::filesystem::path(BLOCKS_PROGRAM).parent_path().string();
  return std::system(("cd '" + folder.path().string() + "' && PATH='" + program_folder +
                      "':$PATH && " + line + " > printed 2>&1")
                         .c_str());
}

/// Returns the words of all commands, and an empty text for the program.
std::vector<std::string> all_pages(const TemporaryFolder& folder) {
  std::vector<std::string> names = commands(folder);
  names.insert(names.end(), {"", "study contacts"});
  return names;
}

/// Returns the index of the first line that begins so, or the number of lines.
std::size_t find_line(const std::vector<std::string>& page, const std::string& begin) {
  const auto found =
      std::find_if(page.begin(), page.end(),
                   [&](const std::string& line) { return line.starts_with(begin); });
  return static_cast<std::size_t>(found - page.begin());
}

TEST(Help, ExamplesWork) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(
      std::filesystem::path(BLOCKS_SOURCE_DIR) / "decks", folder / "decks");
  const std::vector<std::string> names = all_pages(folder);
  ASSERT_GE(names.size(), 12U);
  EXPECT_NE(std::find(names.begin(), names.end(), "export"), names.end());
  const std::string example = "Example: ", after = "(after ";
  for (const std::string& name : names) {
    const auto page = lines(blocks(name + " --help", folder.path()).out);
    const std::size_t at = find_line(page, example);
    ASSERT_LT(at + 1, page.size()) << name;
    if (page[at + 1].starts_with(after)) {
      EXPECT_EQ(
          run_line(page[at + 1].substr(after.size(), page[at + 1].size() - 8), folder),
          0);
    }
    EXPECT_EQ(run_line("{ " + page[at].substr(example.size()) + "; }", folder), 0)
        << page[at] << "\n"
        << slurp(folder / "printed");
  }
}

TEST(Help, GivesPurposeThenUsageThenExample) {
  const TemporaryFolder folder;
  for (const std::string& name : all_pages(folder)) {
    const auto page = lines(blocks(name + " --help", folder.path()).out);
    ASSERT_FALSE(page.empty()) << name;
    const std::size_t usage = find_line(page, "Usage: blocks"),
                      example = find_line(page, "Example: blocks "),
                      options = find_line(page, "Options:");
    ASSERT_LT(options, page.size()) << name;
    EXPECT_EQ(page[usage - 2].back(), '.') << name;  // the end of the purpose
    EXPECT_EQ(page[usage - 1], "") << name;
    EXPECT_LT(usage, example) << name;
    EXPECT_LT(example, options) << name;
  }
}

// Names of C++ types and conditions of the library say nothing to an engineer.
TEST(Help, NamesValuesInWords) {
  const TemporaryFolder folder;
  std::vector<std::string> pages = {blocks("manual program", folder.path()).out};
  for (const std::string& name : all_pages(folder))
    pages.push_back(blocks(name + " --help", folder.path()).out);
  for (const std::string& page : pages)
    for (const char* word : {"TEXT", "INT ", "UINT", "FLOAT", "POSITIVE", "REQUIRED",
                             "9223372036854775807", "Excludes:", "{"})
      EXPECT_THAT(page, Not(HasSubstr(word)));
  const std::string run = blocks("run --help", folder.path()).out;
  EXPECT_THAT(run, HasSubstr("\n  DECK    "));
  for (const char* option :
       {"-o,--output NAME", "--time-limit SECONDS", "--restart FILE", "-j,--threads N"})
    EXPECT_THAT(run, HasSubstr(std::string("\n  ") + option));
}

TEST(Help, FitsATerminalOf80Columns) {
  const TemporaryFolder folder;
  for (const std::string& name : all_pages(folder)) {
    for (const std::string& line : lines(blocks(name + " --help", folder.path()).out))
      EXPECT_LT(line.size(), 80U) << name;
  }
}

}  // namespace
}  // namespace blocks::testing
