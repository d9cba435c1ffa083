#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "exchange/block_record.hpp"

namespace blocks::exchange {
namespace {

/// Returns the section of the physical groups with a name; they are of dimension 2.
std::string groups(const std::map<int, std::string>& names) {
  if (names.empty())
    return "";
  std::string lines;
  for (auto [number, name] : names) {
    std::replace(name.begin(), name.end(), '"', '\'');
    lines += fmt::format("2 {} \"{}\"\n", number, name);
  }
  return fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n", names.size(), lines);
}

}  // namespace

std::string write_gmsh(const std::vector<BlockRecord>& blocks) {
  // Corners are compared by their bits, so that both -0 and 0 are preserved.
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> node_of;
  std::string nodes, elements;
  std::map<int, std::string> names;
  for (const BlockRecord& block : blocks) {
    const geometry::Polygon& outline = block.outline;
    const std::size_t n = outline.size();
    if (n > 4)
      throw std::invalid_argument(fmt::format(
          "block {} has {} corners, a Gmsh element 3 or 4", block.number, n));
    if (!block.material_name.empty())
      names.emplace(block.material, block.material_name);
    elements += fmt::format("{} {} 2 {} {}", block.number, n == 3 ? 2 : 3,
                            block.material, block.material);
    for (std::size_t i = 0; i < n; ++i) {
      const geometry::Vec2& corner = outline[(n - i) % n];
      const auto [node, added] =
          node_of.try_emplace({std::bit_cast<std::uint64_t>(corner.x()),
                               std::bit_cast<std::uint64_t>(corner.y())},
                              node_of.size() + 1);
      if (added)
        nodes += fmt::format("{} {} {} 0\n", node->second, shortest(corner.x()),
                             shortest(corner.y()));
      elements += fmt::format(" {}", node->second);
    }
    elements += "\n";
  }
  return fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{}$Nodes\n{}\n{}$EndNodes"
                     "\n$Elements\n{}\n{}$EndElements\n",
                     groups(names), node_of.size(), nodes, blocks.size(), elements);
}

}  // namespace blocks::exchange
