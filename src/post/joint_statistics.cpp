#include "post/joint_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "geometry/block_shape.hpp"
#include "post/joint_style.hpp"

namespace blocks::post {
namespace {

constexpr double half_turn = 180.0;
constexpr double degree = std::numbers::pi / half_turn;
/// With this many sides, sectors of 5 degrees have enough sides each.
constexpr std::size_t many_sides = 400;
constexpr double wide_sector = 10.0, fine_sector = 5.0;
/// Below this resultant of unit vectors (0: all directions alike, 1: all the same) a
/// mean direction says nothing.
constexpr double least_resultant = 0.4;

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

JointStatistics direction_statistics(const std::vector<DirectedLength>& lengths) {
  double total = 0.0;
  for (const DirectedLength& one : lengths)
    total += one.length;
  JointStatistics result;
  result.sector = lengths.size() < many_sides ? wide_sector : fine_sector;
  const auto sectors = static_cast<std::size_t>(std::lround(half_turn / result.sector));
  std::map<int, std::complex<double>> sums;  // of doubled angles, because they are axes
  for (const DirectedLength& side : lengths) {
    JointDirections& one = result.joints[side.group];
    one.sectors.resize(sectors);
    const long nearest = std::lround(side.direction / result.sector);
    one.sectors[static_cast<std::size_t>(nearest) % sectors] += side.length / total;
    one.share += side.length / total;
    sums[side.group] +=
        side.length / total * std::polar(1.0, 2.0 * side.direction * degree);
  }
  for (auto& [id, one] : result.joints) {
    const double angle = 0.5 * std::arg(sums[id]) / degree;
    one.mean = angle < 0.0 ? angle + half_turn : angle;
    const double resultant = std::min(std::abs(sums[id]) / one.share, 1.0);
    if (resultant >= least_resultant)
      one.deviation = 0.5 * std::sqrt(2.0 * std::abs(std::log(resultant))) / degree;
  }
  return result;
}

JointStatistics joint_statistics(const Frame& frame) {
  const std::vector<DirectedLength> sides = sides_on_joints(frame);
  if (std::none_of(sides.begin(), sides.end(),
                   [](const DirectedLength& side) { return side.length > 0.0; }))
    throw std::runtime_error(no_joints_text());
  JointStatistics result = direction_statistics(sides);
  measure_blocks(frame, result);
  if (result.area.empty())
    throw std::runtime_error("no block at a joint has an area at the time drawn");
  return result;
}

double median_of(std::vector<double> values) {
  if (values.empty())
    return 0.0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1)
    return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace blocks::post
