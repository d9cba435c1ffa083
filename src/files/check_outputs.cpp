#include "files/check_outputs.hpp"

#include <unistd.h>

#include <filesystem>
#include <set>

#include "files/file_tools.hpp"

namespace blocks::files {

namespace fs = std::filesystem;

void check_outputs(const std::vector<std::string>& paths) {
  std::set<fs::path> taken;
  for (const std::string& path : paths) {
    if (path.empty())
      continue;
    const auto cannot = [&](const std::string& why) {
      throw FileError("cannot write " + path + ": " + why);
    };
    std::error_code ignored;
    if (fs::is_directory(path, ignored) || fs::path(path).filename().empty())
      cannot("it is a folder; give the name of a file");
    const fs::path parent = fs::path(path).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string();
    if (!fs::is_directory(folder, ignored))
      cannot("there is no folder " + folder + "; create it with mkdir -p " + folder);
    if (::access(folder.c_str(), W_OK) != 0)
      throw_errno("write", path);
    if (!taken.insert(fs::absolute(path).lexically_normal()).second)
      cannot("two outputs have this name; give each its own");
  }
}

}  // namespace blocks::files
