#include "run/cutting/set_start.hpp"

#include <Eigen/Geometry>

#include <limits>

#include "geometry/cut.hpp"

namespace blocks::run {
namespace {

using Outline = std::vector<geometry::DecimalPoint>;

/// The number of pieces of a set; infinite if there are too many to count.
double pieces(const geometry::JointSet& set, const Outline& outline) {
  try {
    return geometry::expected_pieces(set, outline);
  } catch (const geometry::CutError&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// Returns how far the start is outside of the outline, in sizes of the outline.
double sizes_away(const geometry::JointSet& set, const Outline& outline) {
  Eigen::AlignedBox2d box;
  for (const geometry::DecimalPoint& corner : outline)
    box.extend(Eigen::Vector2d(corner.x.value(), corner.y.value()));
  const Eigen::Vector2d start(set.start.x.value(), set.start.y.value());
  return box.exteriorDistance(start) / box.diagonal().norm();
}

}  // namespace

std::string start_nearby(geometry::JointSet& set, const Outline& outline) {
  constexpr double many = 1e5;  // 190 MB are counted for so many pieces
  geometry::JointSet near = set;
  near.start = outline.front();
  // Joints that run through turn about the point nearest to the start.
  const bool turns = set.dip.deviation.value() > 0.0 && set.trace.mean.value() == 0.0;
  const bool is_far = sizes_away(set, outline) > (turns ? 10.0 : 1000.0);
  if (!is_far && !(pieces(set, outline) - pieces(near, outline) > many))
    return "";
  set = near;
  return is_far ? "(0, 0) is far away" : "many joints would lie between it and (0, 0)";
}

}  // namespace blocks::run
