#include "run/plausibility/plane_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/contact_predicates.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// Returns the distances of the corners of block b behind the plane, [L]; those of
/// corners in front of it are negative.
Eigen::RowVectorXd depths(const Blocks& blocks, int b, const Plane& plane) {
  const Vec2 along = (plane.b - plane.a).normalized();
  const Vec2 backward(along.y(), -along.x());
  return backward.transpose() *
         (blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b))
              .colwise() -
          plane.a);
}

}  // namespace

bool are_all_behind(const Blocks& blocks, const Plane& plane) {
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c]) &&
        geometry::overlap_sign(blocks.corner.col(c), plane.a, plane.b) <= 0)
      return false;
  return true;
}

std::vector<Doubt> doubt_behind_plane(const Plan& plan) {
  const Blocks& blocks = plan.model.blocks;
  const Settings& settings = plan.model.settings;
  const double rounding = 1e-9 * (settings.upper - settings.lower).norm();
  std::vector<Doubt> doubts;
  for (std::size_t k = 0; k < settings.planes.size(); ++k) {
    const Plane& plane = settings.planes[k];
    if (are_all_behind(blocks, plane))
      continue;
    std::vector<int> found;
    double deepest = 0.0;
    int deepest_block = 0;
    for (int b = plan.first_block; b < blocks.size(); ++b) {
      const double depth =
          blocks.is_free(b) ? depths(blocks, b, plane).maxCoeff() : 0.0;
      if (depth <= rounding)
        continue;
      found.push_back(b);
      if (depth > deepest) {
        deepest = depth;
        deepest_block = b;
      }
    }
    if (found.empty())
      continue;
    const auto place = plan.places.planes.find(k);
    doubts.push_back(
        {fmt::format("{} wholly or partly behind the plane, which does not push "
                     "blocks out: {}",
                     counted(found.size(), "free block"), number_ranges(found)),
         fmt::format("block {} reaches {:g} behind it; blocks must be on the left when "
                     "looking from point 1 to point 2",
                     deepest_block + 1, deepest),
         place == plan.places.planes.end() ? std::nullopt
                                           : std::optional(place->second),
         "SPLANE"});
  }
  return doubts;
}

}  // namespace blocks::run
