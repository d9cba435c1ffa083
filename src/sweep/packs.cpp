#include "sweep/packs.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "output/file_tools.hpp"

namespace blocks::sweep {

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
  output::create_folder_of(path);
  output::replace_file(path, fmt::format("{}\n", fmt::join(packs, "\n")));
}

}  // namespace blocks::sweep
