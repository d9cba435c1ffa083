#include "run/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace blocks::run {
namespace {

/// Distance of an edge from its block's centroid, [L].
double depth_below(const Blocks& blocks, int edge, int block) {
  const Vec2 p = blocks.corner.col(edge);
  const Vec2 along = Vec2(blocks.corner.col(blocks.next[edge])) - p;
  return geometry::cross(Vec2(blocks.centroid.col(block)) - p, along) / along.norm();
}

}  // namespace

double half_depth(const Blocks& blocks) {
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < blocks.corners(); ++e)
    if (blocks.convex[blocks.corner_block[e]])
      least = std::min(least, depth_below(blocks, e, blocks.corner_block[e]));
  return 0.5 * std::max(least, 0.0);
}

std::string unsound(const Model& model, const dynamics::Displacement& moved,
                    double half_depth) {
  if (!moved.finite)
    return fmt::format(
        "at time {:g} (step {}) some position is no longer a number; the "
        "time step is probably too large: lower FRACTION",
        model.time, model.steps);
  const double stiffness = model.settings.normal_stiffness;
  if (!(moved.strongest > stiffness * half_depth))
    return "";
  const Contacts& contacts = model.contacts;
  const Blocks& blocks = model.blocks;
  for (int i = 0; i < contacts.size(); ++i) {
    const int block = contacts.edge_block[i];
    const double pressed = contacts.normal_elastic[i] / stiffness;
    if (contacts.active[i] && blocks.convex[block] &&
        pressed > 0.5 * depth_below(blocks, contacts.edge[i], block))
      return fmt::format(
          "at time {:g} (step {}) a contact of blocks {} and {} is pressed in by "
          "{:.3g}, more than half of what the block is deep; raise STIFF, or lower "
          "FRACTION if the run is unstable",
          model.time, model.steps, contacts.corner_block[i] + 1, block + 1, pressed);
  }
  return "";
}

}  // namespace blocks::run
