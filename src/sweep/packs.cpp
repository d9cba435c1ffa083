#include "sweep/packs.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "files/file_tools.hpp"

namespace blocks::sweep {
namespace {

/// Whether a line of a file can be a pack, such as 17-32.
bool is_pack(const std::string& line) {
  return line.find_first_not_of("0123456789-") == std::string::npos;
}

}  // namespace

std::vector<std::string> packs_of(const std::vector<std::size_t>& ids,
                                  std::size_t size) {
  std::vector<std::string> packs;
  for (std::size_t i = 0; i < ids.size(); i += size) {
    const std::size_t last = std::min(i + size, ids.size()) - 1;
    packs.push_back(ids[i] == ids[last] ? fmt::format("{}", ids[i])
                                        : fmt::format("{}-{}", ids[i], ids[last]));
  }
  return packs;
}

void write_packs(const std::string& path, const std::vector<std::string>& packs) {
  files::expect_no_link(std::filesystem::path(path).parent_path().string());
  files::create_folder_of(path);
  const std::vector<std::string> older = lines_of(path);
  if (!std::all_of(older.begin(), older.end(), is_pack))
    files::set_aside(path);
  files::replace_file(path, fmt::format("{}\n", fmt::join(packs, "\n")));
}

std::vector<std::string> lines_of(const std::string& path) {
  files::expect_regular(path);
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

}  // namespace blocks::sweep
