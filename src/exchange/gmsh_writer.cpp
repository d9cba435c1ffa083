#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>

#include "exchange/block_record.hpp"
#include "geometry/triangles.hpp"

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

/// The nodes of a file, with numbers from 1.
class Nodes {
 public:
  /// Returns the node at this point. Points are compared by their bits, so that both -0
  /// and 0 are preserved.
  std::size_t at(const geometry::Vec2& corner) {
    const auto [node, added] =
        number_.try_emplace({std::bit_cast<std::uint64_t>(corner.x()),
                             std::bit_cast<std::uint64_t>(corner.y())},
                            number_.size() + 1);
    if (added)
      lines_ += fmt::format("{} {} {} 0\n", node->second, shortest(corner.x()),
                            shortest(corner.y()));
    return node->second;
  }

  std::string section() const {
    return fmt::format("$Nodes\n{}\n{}$EndNodes\n", number_.size(), lines_);
  }

 private:
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> number_;
  std::string lines_;
};

/// The elements of a file.
struct Elements {
  std::size_t count = 0;
  std::string lines;

  /// Adds an element. physical: physical group and elementary tag.
  void add(std::size_t number, int type, int physical,
           const std::vector<std::size_t>& nodes) {
    ++count;
    lines += fmt::format("{} {} 2 {} {} {}\n", number, type, physical, physical,
                         fmt::join(nodes, " "));
  }
};

constexpr int line = 1, triangle = 2, quadrilateral = 3;  // Gmsh's element types

/// Adds a line element for each side with a joint id. Sides of two blocks with the same
/// ends and id share one.
void add_lines(const BlockRecord& block, const std::vector<std::size_t>& corners,
               std::set<std::array<std::size_t, 3>>& known, Elements& elements) {
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    const std::size_t begin = corners[i], end = corners[(i + 1) % corners.size()];
    const int joint = block.joints[i];
    if (joint != 0 && known
                          .insert({std::min(begin, end), std::max(begin, end),
                                   static_cast<std::size_t>(joint)})
                          .second)
      elements.add(elements.count + 1, line, joint, {begin, end});
  }
}

void add_triangles(const BlockRecord& block, const std::vector<std::size_t>& corners,
                   Elements& elements) {
  const auto parts = geometry::triangles(block.outline);
  if (parts.empty())
    throw std::invalid_argument(fmt::format(
        "block {} cannot be cut into Gmsh elements: its outline is not simple",
        block.number));
  for (const auto& [a, b, c] : parts)  // clockwise
    elements.add(elements.count + 1, triangle, block.material,
                 {corners[static_cast<std::size_t>(a)],
                  corners[static_cast<std::size_t>(c)],
                  corners[static_cast<std::size_t>(b)]});
}

/// Returns the line of a block in $Blocks.
std::string ring_line(const BlockRecord& block,
                      const std::vector<std::size_t>& corners) {
  std::string text =
      fmt::format("{} {} {}", block.material, block.fixed ? 1 : 0, corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    text +=
        fmt::format(" {} {}", corners[i], block.joints.empty() ? 0 : block.joints[i]);
  return text + "\n";
}

}  // namespace

bool needs_rings(const std::vector<BlockRecord>& blocks) {
  return has_joints(blocks) ||
         std::any_of(blocks.begin(), blocks.end(),
                     [](const BlockRecord& block) { return block.outline.size() > 4; });
}

std::string write_gmsh(const std::vector<BlockRecord>& blocks) {
  Nodes nodes;
  std::map<int, std::string> names;
  std::vector<std::vector<std::size_t>> corners(blocks.size());  // nodes, clockwise
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BlockRecord& block = blocks[b];
    const std::size_t n = block.outline.size();
    corners[b].resize(n);
    for (std::size_t i = 0; i < n; ++i)  // anticlockwise
      corners[b][(n - i) % n] = nodes.at(block.outline[(n - i) % n]);
    if (!block.material_name.empty())
      names.emplace(block.material, block.material_name);
  }

  const bool with_rings = needs_rings(blocks);
  Elements elements;
  std::set<std::array<std::size_t, 3>> sides;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    add_lines(blocks[b], corners[b], sides, elements);
  std::string rings;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BlockRecord& block = blocks[b];
    std::vector<std::size_t> ring = corners[b];
    if (with_rings)
      rings += ring_line(block, ring);
    if (ring.size() > 4) {
      add_triangles(block, ring, elements);
      continue;
    }
    std::reverse(ring.begin() + 1, ring.end());
    elements.add(with_rings ? elements.count + 1
                            : static_cast<std::size_t>(block.number),
                 ring.size() == 3 ? triangle : quadrilateral, block.material, ring);
  }
  if (with_rings)
    rings = fmt::format("$Blocks\n{}\n{}$EndBlocks\n", blocks.size(), rings);
  return fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{}{}{}$Elements\n{}\n{}"
                     "$EndElements\n",
                     groups(names), nodes.section(), rings, elements.count,
                     elements.lines);
}

}  // namespace blocks::exchange
