// The help of every command begins with an example that works in this repository.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::StartsWith;

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

TEST(Help, ExamplesWork) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(
      std::filesystem::path(BLOCKS_SOURCE_DIR) / "decks", folder / "decks");
  std::vector<std::string> names = commands(folder);
  ASSERT_GE(names.size(), 10U);
  EXPECT_NE(std::find(names.begin(), names.end(), "export"), names.end());
  names.insert(names.end(), {"", "study contacts"});
  const std::string after = "(after ";
  for (const std::string& name : names) {
    const auto page = lines(blocks(name + " --help", folder.path()).out);
    ASSERT_GT(page.size(), 3U) << name;
    ASSERT_THAT(page[0], StartsWith("Example: blocks ")) << name;
    if (page[1].starts_with(after)) {
      EXPECT_EQ(run_line(page[1].substr(after.size(), page[1].size() - 8), folder), 0);
    }
    EXPECT_EQ(run_line("{ " + page[0].substr(9) + "; }", folder), 0)
        << page[0] << "\n"
        << slurp(folder / "printed");
  }
}

}  // namespace
}  // namespace blocks::testing
