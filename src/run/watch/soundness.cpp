#include "run/watch/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/compression.hpp"

namespace blocks::run {
namespace {

/// Depth of a point below the line from p to q, [L].
double depth_below(const Vec2& p, const Vec2& q, const Vec2& point) {
  return geometry::cross(point - p, q - p) / (q - p).norm();
}
double depth_of_middle(const Blocks& blocks, int edge, int block) {
  return depth_below(blocks.corner.col(edge), blocks.corner.col(blocks.next[edge]),
                     blocks.centroid.col(block));
}

/// Extent of a block across the direction from p to q, [L].
double extent_across(const Blocks& blocks, const Vec2& p, const Vec2& q, int block) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int c = blocks.first_corner[block]; c < blocks.first_corner[block + 1]; ++c) {
    const double depth = depth_below(p, q, blocks.corner.col(c));
    low = std::min(low, depth), high = std::max(high, depth);
  }
  return high - low;
}

/// The first block with a corner whose position is not finite; -1 if there is none.
int first_without_place(const Blocks& blocks) {
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.corner.col(c).allFinite())
      return blocks.corner_block[c];
  return -1;
}

}  // namespace

double half_depth(const Blocks& blocks) {
  double min = std::numeric_limits<double>::infinity();
  for (int e = 0; e < blocks.corners(); ++e)
    if (const int b = blocks.corner_block[e]; blocks.convex[b] && !blocks.is_removed(b))
      min = std::min(min, depth_of_middle(blocks, e, b));
  return 0.5 * std::max(min, 0.0);
}

bool may_be_unsound(const Settings& settings, const dynamics::StepResult& moved,
                    double half_depth) {
  return !moved.finite || moved.strongest > settings.normal_stiffness * half_depth ||
         moved.largest > std::max(settings.contact_tolerance, half_depth);
}

std::string unsound(const Model& model, const dynamics::StepResult& moved,
                    double half_depth) {
  const Blocks& blocks = model.blocks;
  const int lost = moved.finite ? -1 : first_without_place(blocks);
  if (!moved.finite && lost < 0)
    return fmt::format("at time {:g} (step {}) the blocks are too far away to compute "
                       "with (1e150); reduce their loads or velocities",
                       model.time, model.steps);
  if (!moved.finite)
    return fmt::format(
        "at time {:g} (step {}) the position of block {} is no longer a number; the "
        "time step is probably too large: lower FRACTION",
        model.time, model.steps, lost + 1);
  const double tolerance = model.settings.contact_tolerance;
  if (moved.largest > std::max(tolerance, half_depth))
    return fmt::format(
        "at time {:g} (step {}) block {} moved a corner by {:.3g} in one step, more "
        "than "
        "ctol ({:g}) and than half the way to the middle of the shallowest block "
        "({:.3g}): it may have passed through another; lower FRACTION or its velocity",
        model.time, model.steps, moved.block + 1, moved.largest, tolerance, half_depth);
  const double stiffness = model.settings.normal_stiffness;
  if (!(moved.strongest > stiffness * half_depth))
    return "";
  for (const PlaneContact& contact : model.plane_contacts) {
    if (!contact.active)
      continue;
    const Plane& plane = model.settings.planes[contact.plane];
    const int block = blocks.corner_block[contact.corner];
    const double pressed = contact.normal_elastic / stiffness;
    const double above = 0.5 * extent_across(blocks, plane.a, plane.b, block);
    if (pressed > 0.5 * above)
      return fmt::format(
          "at time {:g} (step {}) a contact of block {} and a symmetry plane is "
          "pressed "
          "in by {:.3g}, more than half the way to the middle of the block ({:.3g}); "
          "raise STIFF, or lower FRACTION if the run is unstable",
          model.time, model.steps, block + 1, pressed, above);
  }
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const Contact& contact = model.contacts[i];
    const int edge = contact.edge, block = blocks.corner_block[edge];
    const int other = blocks.corner_block[contact.corner];
    const double pressed =
        compression(model.settings, model.contacts, model.law_states, i);
    const double behind = depth_of_middle(blocks, edge, block);
    const double above =
        0.5 * extent_across(blocks, blocks.corner.col(edge),
                            blocks.corner.col(blocks.next[edge]), other);
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
