#include "post/chart/joint_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "geometry/block_shape.hpp"
#include "post/read/joint_ids.hpp"

namespace blocks::post {

using namespace draw;

namespace {

constexpr double half_turn = 180.0;
constexpr double degree = std::numbers::pi / half_turn;

std::vector<DirectedLength> sides_on_joints(const Frame& frame) {
  std::vector<DirectedLength> found;
  for (std::size_t b = 0; b < frame.joints.size(); ++b) {
    const auto& outline = frame.outlines[b];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      if (frame.joints[b][k] == 0)
        continue;
      const Eigen::Vector2d d = outline[(k + 1) % outline.size()] - outline[k];
      const double angle = std::atan2(d.y(), d.x()) / degree;
      found.push_back({frame.joints[b][k],
                       std::fmod(angle + 2.0 * half_turn, half_turn), d.norm()});
    }
  }
  return found;
}

void measure_blocks(const Frame& frame, JointStatistics& result) {
  for (std::size_t b = 0; b < frame.joints.size(); ++b) {
    const auto& ids = frame.joints[b];
    if (std::all_of(ids.begin(), ids.end(), [](int id) { return id == 0; }))
      continue;
    const geometry::BlockShape shape = geometry::measure_shape(frame.outlines[b]);
    if (!(shape.area > 0.0) || !std::isfinite(shape.area * shape.aspect))
      continue;  // a block of zero width has no aspect ratio
    result.area.push_back(shape.area);
    result.aspect.push_back(shape.aspect);
    result.sides.push_back(static_cast<double>(ids.size()));
  }
}

}  // namespace

JointStatistics joint_statistics(const Frame& frame) {
  const std::vector<DirectedLength> sides = sides_on_joints(frame);
  if (std::none_of(sides.begin(), sides.end(),
                   [](const DirectedLength& side) { return side.length > 0.0; }))
    throw std::runtime_error(no_joints_text());
  JointStatistics result{direction_statistics(sides), {}, {}, {}};
  measure_blocks(frame, result);
  if (result.area.empty())
    throw std::runtime_error("no block at a joint has an area at the time drawn");
  return result;
}

}  // namespace blocks::post
