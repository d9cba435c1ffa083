#include <fmt/format.h>

#include "exchange/block_record.hpp"

namespace blocks::exchange {

std::string write_wkt(const std::vector<BlockRecord>& blocks) {
  const bool with_joints = has_joints(blocks);
  std::string text;
  for (const BlockRecord& block : blocks) {
    text += with_joints ? "POLYGON M ((" : "POLYGON ((";
    const char* separator = "";
    for (const auto& [corner, joint] : closed_ring(block)) {
      text +=
          fmt::format("{}{} {}", separator, shortest(corner.x()), shortest(corner.y()));
      if (with_joints)
        text += fmt::format(" {}", joint);
      separator = ", ";
    }
    text += "))\n";
  }
  return text;
}

}  // namespace blocks::exchange
