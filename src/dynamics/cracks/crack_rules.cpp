#include "dynamics/cracks/crack_rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/preparation/time_step.hpp"

namespace blocks::dynamics {
namespace {

/// The cosine of 20 degrees.
constexpr double min_cosine = 0.93969262078590838;

/// A symmetric tensor as its mean, half the difference of its normal components, and
/// its shear.
struct MohrCircle {
  double mean, half, shear;

  explicit MohrCircle(const Eigen::Vector4d& tensor)
      : mean(0.5 * (tensor[0] + tensor[3])), half(0.5 * (tensor[0] - tensor[3])),
        shear(0.5 * (tensor[1] + tensor[2])) {}
  double radius() const { return std::sqrt(half * half + shear * shear); }
  /// The axis of the largest principal value. The radius must not be 0. Half angles
  /// follow from square roots, so all machines give the same bits.
  Vec2 axis() const {
    const double cosine = half / radius();
    const double larger = std::sqrt(0.5 * (1.0 + std::abs(cosine)));
    const double other = 0.5 * (shear / radius()) / larger;
    return half >= 0.0 ? Vec2(larger, other) : Vec2(other, larger);
  }
};

}  // namespace

double largest_principal(const Eigen::Vector4d& tensor) {
  const MohrCircle circle(tensor);
  return circle.mean + circle.radius();
}

std::optional<CrackDemand> crack_by_stress(const Blocks& blocks, int b, bool rigid,
                                           const CrackRule& rule) {
  const Eigen::Vector4d stress = rigid ? blocks.applied.col(b) : blocks.stress.col(b);
  const double largest = largest_principal(stress);
  if (!(largest >= rule.strength))
    return {};
  const MohrCircle circle(stress);
  Vec2 normal(1.0, 0.0);
  if (circle.radius() > 0.0)
    normal = circle.axis();
  else if (const Vec2 size = extent(blocks, b); size.y() > size.x())
    normal = Vec2(0.0, 1.0);
  return CrackDemand{CrackCause::stress,
                     largest,
                     {blocks.centroid.col(b), Vec2(-normal.y(), normal.x())}};
}

std::vector<CrackDemand> cracks_by_point_loads(const std::vector<PointLoad>& loads,
                                               double shortest, const CrackRule& rule) {
  std::vector<CrackDemand> found;
  if (!(rule.point_strength > 0.0))
    return found;
  for (std::size_t i = 0; i < loads.size(); ++i)
    for (std::size_t k = i + 1; k < loads.size(); ++k) {
      const Vec2 chord = loads[k].at - loads[i].at;
      const double length = chord.norm();
      if (!(length >= shortest))
        continue;
      const double first = loads[i].force.dot(chord) / length;
      const double second = -loads[k].force.dot(chord) / length;
      if (!(first >= min_cosine * loads[i].force.norm()) ||
          !(second >= min_cosine * loads[k].force.norm()))
        continue;
      const double stress = 2.0 * std::min(first, second) / (std::numbers::pi * length);
      if (stress >= rule.point_strength)
        found.push_back({CrackCause::point_loads,
                         stress,
                         {0.5 * (loads[i].at + loads[k].at), chord}});
    }
  std::stable_sort(
      found.begin(), found.end(),
      [](const CrackDemand& l, const CrackDemand& r) { return l.stress > r.stress; });
  return found;
}

}  // namespace blocks::dynamics
