#include "validation/cells/networks.hpp"

#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <cmath>
#include <numbers>

namespace blocks::validation {

using namespace geometry;
using std::numbers::pi;

Decimal decimal(double value) {
  return Decimal::parse(fmt::format("{:.6f}", value)).value();
}

std::vector<DecimalPoint> polygon(const std::vector<Vec2>& corners) {
  std::vector<DecimalPoint> result;
  for (const Vec2& p : corners)
    result.push_back({decimal(p.x()), decimal(p.y())});
  return result;
}

std::vector<DecimalPoint> rectangle(double width, double height) {
  return polygon({{0, 0}, {0, height}, {width, height}, {width, 0}});
}

// A set whose track 0 is far from the outline, at a random phase. Seen from the
// outline, the tracks are stationary, as the exact values require.
JointSet distant_set(double dip, double space, std::uint64_t seed, std::uint64_t card) {
  JointSet set;
  set.id = static_cast<int>(card);
  set.dip.mean = decimal(dip);
  set.spacing.mean = decimal(space);
  set.stream = {seed, card};
  constexpr double distance = 300.0;
  constexpr std::uint32_t start_use = 99;
  const double part =
      static_cast<double>(random_53_bits(set.stream, 0, 0, start_use)) * 0x1p-53;
  const double angle = dip * pi / 180.0, far = distance + part * space;
  set.start = {decimal(far * std::sin(angle)), decimal(-far * std::cos(angle))};
  return set;
}

CutRequest request(const std::vector<DecimalPoint>& outline,
                   const std::vector<JointSet>& sets) {
  CutRequest result;
  result.outline = outline;
  for (const JointSet& set : sets) {
    const auto pieces = joint_set(set, outline);
    result.joints.insert(result.joints.end(), pieces.begin(), pieces.end());
  }
  return result;
}

CutRequest poisson_lines(const std::vector<DecimalPoint>& outline, double tau,
                         std::uint64_t seed) {
  JointSet set;
  set.id = 1;
  set.spacing.mean = decimal(1.0 / tau);
  set.law = SpacingLaw::poisson;
  set.start = outline[0];
  set.stream = {seed, 1};
  return request(outline, {set});
}

CutRequest poisson_voronoi(const std::vector<DecimalPoint>& outline, double mean_points,
                           std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  VoronoiRequest cells;
  cells.id = 1;
  cells.count = boost::random::poisson_distribution<int>(mean_points)(random);
  cells.stream = {seed, 1};
  CutRequest result;
  result.outline = outline;
  result.joints = voronoi_cells(cells, outline).edges;
  return result;
}

}  // namespace blocks::validation
