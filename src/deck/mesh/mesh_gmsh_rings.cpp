// The section $Blocks of Gmsh files that `blocks export` wrote (docs/mesh-formats.md).
#include <fmt/format.h>

#include <algorithm>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {

MeshBlock read_ring(const Lines& lines, Elements& elements, const std::string& name) {
  constexpr std::size_t first_node = 3;
  const long material = lines.integer(0, name + ": material");
  const long fixed = lines.integer(1, name + ": fixed");
  if (fixed != 0 && fixed != 1)
    fail(lines.place(),
         fmt::format("{}: fixed should be 0 or 1, found {}", name, fixed));
  const long corners = lines.integer(2, name + ": number of corners");
  if (corners < 3)
    fail(lines.place(), name + " needs at least 3 corners");
  const std::size_t values = lines.fields().size() - first_node;
  if (static_cast<std::size_t>(corners) != values / 2 || values % 2 != 0)
    fail(lines.place(),
         fmt::format("{}: {} corners need a node and a joint id each; found {} after "
                     "their number",
                     name, corners, counted(values, "value")),
         "if the section $Blocks is removed, the elements are read instead");
  std::vector<long> nodes;
  std::vector<int> joints;
  for (std::size_t field = first_node; field < first_node + values; field += 2) {
    const std::string corner =
        fmt::format("{}: corner {} of {}", name, nodes.size() + 1, corners);
    nodes.push_back(lines.integer(field, corner + ": node"));
    joints.push_back(lines.joint(field + 1, corner + ": joint id"));
  }
  if (std::count(joints.begin(), joints.end(), 0) == corners)
    joints.clear();
  MeshBlock block =
      elements.ring(nodes, std::move(joints), material, name, lines.place());
  block.fixed = fixed == 1;
  return block;
}

}  // namespace blocks::deck::mesh
