#include "exchange/mesh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "exchange/block_record.hpp"

namespace blocks::exchange {

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  return text;
}

std::string write_mesh(const std::vector<Outline>& outlines,
                       const std::string& comment) {
  std::string text =
      fmt::format("$ {}\nBLOCKS {}\n", one_line(comment), outlines.size());
  for (const Outline& outline : outlines) {
    text += fmt::format("{}, {}\n", outline.corners.size(), outline.material);
    const bool with_joints = std::any_of(outline.joints.begin(), outline.joints.end(),
                                         [](int joint) { return joint != 0; });
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
      if (!outline.written.empty())
        text += fmt::format("  {}, {}", outline.written[i][0], outline.written[i][1]);
      else
        text += fmt::format("  {}, {}", shortest(outline.corners[i].x()),
                            shortest(outline.corners[i].y()));
      text += with_joints ? fmt::format(", {}\n", outline.joints[i]) : "\n";
    }
  }
  return text;
}

}  // namespace blocks::exchange
