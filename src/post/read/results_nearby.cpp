#include "post/read/results_nearby.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "output/results/results_mark.hpp"

namespace blocks::post {

namespace fs = std::filesystem;

std::string fault_of_head(const std::string& path) {
  std::error_code ignored;
  const fs::file_status there = fs::status(path, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_directory(there))
    return "it is not a regular file";  // opening a FIFO may never end
  std::ifstream in(path, std::ios::binary);
  if (!in || fs::is_directory(path, ignored))
    return {};  // opening the file reports why
  std::string head(8, '\0');
  in.read(head.data(), 8);
  if (in.gcount() == 0)
    return "it is empty";
  if (head == output::results_head && fs::file_size(path, ignored) <= output::mark_size)
    return "it is truncated, it has no data; copy it again or repeat the run";
  const bool older = head == "\x89HDF\r\n\x1a\n";  // older results have no mark
  return older || head == output::results_head ? ""
                                               : "it is not a results file of BLOCKS";
}

std::string results_nearby(const std::string& path) {
  constexpr std::size_t max = 5;
  std::error_code ignored;
  const fs::path parent = fs::path(path).parent_path();
  std::vector<fs::directory_entry> found;
  for (const auto& entry :
       fs::directory_iterator(parent.empty() ? "." : parent, ignored))
    if (entry.path().extension() == ".vtkhdf" && entry.is_regular_file(ignored) &&
        entry.path().filename() != fs::path(path).filename() &&
        fault_of_head(entry.path().string()).empty())
      found.push_back(entry);
  if (found.empty())
    return "\n  hint: blocks run DECK writes results to NAME.vtkhdf";
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return a.last_write_time(ignored) > b.last_write_time(ignored);
  });
  std::string text;
  for (std::size_t i = 0; i < std::min(found.size(), max); ++i)
    text += (i > 0 ? ", " : "") + (parent / found[i].path().filename()).string();
  return "\n  hint: results in this folder: " + text +
         (found.size() > max ? ", ..." : "");
}

}  // namespace blocks::post
