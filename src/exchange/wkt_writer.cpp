#include <fmt/format.h>

#include "exchange/block_record.hpp"

namespace blocks::exchange {

std::string write_wkt(const std::vector<BlockRecord>& blocks) {
  std::string text;
  for (const BlockRecord& block : blocks) {
    const geometry::Polygon& outline = block.outline;
    text += "POLYGON ((";
    for (std::size_t i = 0; i <= outline.size(); ++i) {
      const geometry::Vec2& corner = outline[(outline.size() - i) % outline.size()];
      text += fmt::format("{}{} {}", i > 0 ? ", " : "", shortest(corner.x()),
                          shortest(corner.y()));
    }
    text += "))\n";
  }
  return text;
}

}  // namespace blocks::exchange
