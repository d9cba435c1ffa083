#include "run/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace blocks::run {
namespace {

/// How deep a point is below an edge, [L].
double depth_below(const Blocks& blocks, int edge, const Vec2& point) {
  const Vec2 p = blocks.corner.col(edge);
  const Vec2 along = Vec2(blocks.corner.col(blocks.next[edge])) - p;
  return geometry::cross(point - p, along) / along.norm();
}
double depth_of_middle(const Blocks& blocks, int edge, int block) {
  return depth_below(blocks, edge, blocks.centroid.col(block));
}

/// Extent of a block across the direction of an edge, [L].
double extent_across(const Blocks& blocks, int edge, int block) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int c = blocks.first_corner[block]; c < blocks.first_corner[block + 1]; ++c) {
    const double depth = depth_below(blocks, edge, blocks.corner.col(c));
    low = std::min(low, depth), high = std::max(high, depth);
  }
  return high - low;
}

}  // namespace

double half_depth(const Blocks& blocks) {
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < blocks.corners(); ++e)
    if (blocks.convex[blocks.corner_block[e]])
      least = std::min(least, depth_of_middle(blocks, e, blocks.corner_block[e]));
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
  for (const ActingContact& contact : contacts.acting) {
    const int i = contact.record;
    const int edge = contacts.edge[i], block = blocks.corner_block[edge];
    const int other = blocks.corner_block[contacts.corner[i]];
    const double pressed = contact.normal_elastic / stiffness;
    const double behind = depth_of_middle(blocks, edge, block);
    const double above = 0.5 * extent_across(blocks, edge, other);
    const bool to_behind = blocks.convex[block] && pressed > 0.5 * behind;
    if (to_behind || (blocks.convex[other] && pressed > 0.5 * above))
      return fmt::format(
          "at time {:g} (step {}) a contact of blocks {} and {} is pressed in by "
          "{:.3g}, more than half the way to the middle of block {} ({:.3g}); raise "
          "STIFF, or lower FRACTION if the run is unstable",
          model.time, model.steps, other + 1, block + 1, pressed,
          (to_behind ? block : other) + 1, to_behind ? behind : above);
  }
  return "";
}

}  // namespace blocks::run
