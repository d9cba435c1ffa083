#include "model/water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks {

using geometry::Vec2;

namespace {

double passed_part(double begin, double duration, double time) {
  return duration > 0.0 ? std::clamp((time - begin) / duration, 0.0, 1.0) : 1.0;
}

/// Adds the loads of a pressure that is linear from p0 at t0 to p1 at t1. Only positive
/// pressure acts.
void add_linear(double t0, double p0, double t1, double p1, EndLoads& loads) {
  if (!(t1 > t0) || (p0 <= 0.0 && p1 <= 0.0))
    return;
  if (p0 < 0.0) {
    t0 += (t1 - t0) * (p0 / (p0 - p1));
    p0 = 0.0;
  } else if (p1 < 0.0) {
    t1 -= (t1 - t0) * (p1 / (p1 - p0));
    p1 = 0.0;
  }
  const double width = t1 - t0;
  // Both are integrals of non-negative functions, so nothing cancels.
  loads.second += width * (0.5 * t0 * (p0 + p1) + width * (p0 + 2.0 * p1) / 6.0);
  loads.first += width * (0.5 * (1.0 - t1) * (p0 + p1) + width * (2.0 * p0 + p1) / 6.0);
}

/// Shortens [t0, t1] to where low <= from + t (to - from) <= high.
void clip(double from, double to, double low, double high, double& t0, double& t1) {
  const double change = to - from;
  if (change == 0.0) {
    if (!(low <= from && from <= high))
      t1 = t0;
    return;
  }
  const double one = (low - from) / change, other = (high - from) / change;
  t0 = std::max(t0, std::min(one, other));
  t1 = std::min(t1, std::max(one, other));
}

/// The place of a point with respect to the line of a card.
struct OnLine {
  double along, distance;  ///< from 0 at a to 1 at b; [L]
};
OnLine on_line(const JointWater& water, const Vec2& at) {
  const Vec2 line = water.b - water.a, from = at - water.a;
  return {from.dot(line) / line.squaredNorm(),
          geometry::cross(line, from) / line.norm()};
}

double pressure_at(const JointWater& water, double along, double passed) {
  return passed * (water.p1 + along * (water.p2 - water.p1));
}

/// Adds the loads of one card on the side from a to b.
void add_line(const JointWater& water, double time, const Vec2& a, const Vec2& b,
              EndLoads& loads) {
  if (water.is_dry())
    return;
  const OnLine first = on_line(water, a), second = on_line(water, b);
  double t0 = 0.0, t1 = 1.0;
  clip(first.along, second.along, 0.0, 1.0, t0, t1);
  clip(first.distance, second.distance, -water.reach, water.reach, t0, t1);
  const double passed = water.passed(time);
  const auto at = [&](double t) {
    return pressure_at(water, first.along + t * (second.along - first.along), passed);
  };
  add_linear(t0, at(t0), t1, at(t1), loads);
}

/// Adds the forces at the ends of the side from corner c.
void add_side(const Blocks& blocks, int c, const EndLoads& loads, BlockWater& sum) {
  if (!(loads.first > 0.0) && !(loads.second > 0.0))
    return;
  const int d = blocks.next[c];
  const Vec2 along = blocks.corner.col(d) - blocks.corner.col(c);
  const Vec2 inward(along.y(), -along.x());
  for (const auto& [corner, load] : {std::pair{c, loads.first}, {d, loads.second}}) {
    const Vec2 arm = blocks.present_arm(corner), f = load * inward;
    sum.force += f;
    sum.moment += geometry::cross(arm, f);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        sum.sums[2 * i + j] += f[i] * arm[j];
  }
  sum.acts = true;
}

}  // namespace

double WaterTable::passed(double time) const {
  return passed_part(begin, duration, time);
}

double JointWater::passed(double time) const {
  return passed_part(begin, duration, time);
}

bool Water::has_own(int joint) const {
  return std::any_of(joints.begin(), joints.end(),
                     [&](const JointWater& one) { return one.joint == joint; });
}

bool Water::will_change(double time) const {
  const auto changes = [&](const auto& one) {
    return one.duration > 0.0 && time < one.begin + one.duration;
  };
  return (!table.none() && changes(table)) ||
         std::any_of(joints.begin(), joints.end(), changes);
}

WaterNow::WaterNow(const Water& water, double time)
    : water_(water), time_(time), passed_(water.table.passed(time)),
      across_(water.table.across()) {}

double WaterNow::level(std::size_t k) const {
  const WaterTable& table = water_.table;
  return table.from[k] + passed_ * (table.to[k] - table.from[k]);
}

/// Returns the number of the part at the place s: 0 before the first point. A table of
/// one point has one part.
std::size_t WaterNow::part_at(double s) const {
  const std::vector<double>& place = water_.table.place;
  if (place.size() == 1)
    return 0;
  return static_cast<std::size_t>(std::upper_bound(place.begin(), place.end(), s) -
                                  place.begin());
}

WaterNow::Part WaterNow::part(std::size_t k) const {
  const std::vector<double>& place = water_.table.place;
  if (k == 0)
    return {place.front(), level(0), 0.0};
  const double low = level(k - 1);
  return {place[k - 1], low,
          k == place.size() ? 0.0 : (level(k) - low) / (place[k] - place[k - 1])};
}

double WaterNow::level_at(double s) const {
  const Part straight = part(part_at(s));
  return straight.level + straight.slope * (s - straight.place);
}

double WaterNow::table_pressure(const Part& part, const Vec2& at) const {
  const WaterTable& table = water_.table;
  return table.gamma *
         (part.level + part.slope * (across_.dot(at) - part.place) - table.up.dot(at));
}

double WaterNow::pressure(const Vec2& at, int joint) const {
  if (!water_.has_own(joint))
    return water_.table.none()
               ? 0.0
               : std::max(0.0, table_pressure(part(part_at(across_.dot(at))), at));
  double sum = 0.0;
  for (const JointWater& one : water_.joints) {
    if (one.joint != joint || one.is_dry())
      continue;
    const OnLine place = on_line(one, at);
    if (place.along >= 0.0 && place.along <= 1.0 &&
        std::abs(place.distance) <= one.reach)
      sum += std::max(0.0, pressure_at(one, place.along, one.passed(time_)));
  }
  return sum;
}

Vec2 WaterNow::at_ends(const Vec2& a, const Vec2& b, int joint) const {
  if (water_.has_own(joint))
    return {pressure(a, joint), pressure(b, joint)};
  if (water_.table.none())
    return {0.0, 0.0};
  const auto below = [&](const Vec2& at) {
    return table_pressure(part(part_at(across_.dot(at))), at);
  };
  const Vec2 ends(below(a), below(b));
  return ends.maxCoeff() > 0.0 ? ends : Vec2(0.0, 0.0);
}

EndLoads WaterNow::table_on(const Vec2& a, const Vec2& b) const {
  EndLoads loads;
  const double begin = across_.dot(a), end = across_.dot(b);
  const std::vector<double>& place = water_.table.place;
  const std::size_t first = part_at(begin), last = part_at(end);
  // Parts from the left to the right; t runs from a to b.
  const bool rises = end >= begin;
  const std::size_t low = std::min(first, last), high = std::max(first, last);
  const auto t_of = [&](double s) {
    return std::clamp((s - begin) / (end - begin), 0.0, 1.0);
  };
  for (std::size_t k = low; k <= high; ++k) {
    const double left = k == low ? (rises ? 0.0 : 1.0) : t_of(place[k - 1]),
                 right = k == high ? (rises ? 1.0 : 0.0) : t_of(place[k]);
    const Part straight = part(k);
    const double t0 = std::min(left, right), t1 = std::max(left, right);
    const auto at = [&](double t) -> double {
      return table_pressure(straight, a + t * (b - a));
    };
    add_linear(t0, at(t0), t1, at(t1), loads);
  }
  return loads;
}

EndLoads WaterNow::on_side(const Vec2& a, const Vec2& b, int joint) const {
  if (!water_.has_own(joint))
    return water_.table.none() ? EndLoads{} : table_on(a, b);
  EndLoads loads;
  for (const JointWater& one : water_.joints)
    if (one.joint == joint)
      add_line(one, time_, a, b, loads);
  return loads;
}

bool WaterNow::has_own_sides(const Blocks& blocks, int b) const {
  if (water_.joints.empty())
    return false;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
    if (water_.has_own(blocks.joint[c]))
      return true;
  return false;
}

/// Finds the resultant if all corners lie under, or all above, one straight part of the
/// table. The pressure is then linear over the whole block: by the theorem of Gauss,
/// the force is minus the area times its gradient, it acts at the centroid, and the
/// sums f_i x_j are minus the area times the pressure there.
bool WaterNow::under_one_part(const Blocks& blocks, int b, BlockWater& result) const {
  const int begin = blocks.first_corner[b], end = blocks.first_corner[b + 1];
  const std::size_t k = part_at(across_.dot(Vec2(blocks.corner.col(begin))));
  const Part straight = part(k);
  const std::vector<double>& place = water_.table.place;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double left = k == 0 ? -infinity : place[k - 1],
               right = k == place.size() || place.size() == 1 ? infinity : place[k];
  const Vec2 centre = blocks.centroid.col(b);
  double least = infinity, most = -infinity, twice_area = 0.0;
  Vec2 before = Vec2(blocks.corner.col(end - 1)) - centre;
  for (int c = begin; c < end; ++c) {
    const Vec2 at = blocks.corner.col(c);
    const double s = across_.dot(at), p = table_pressure(straight, at);
    if (!(left <= s && s <= right))
      return false;
    least = std::min(least, p);
    most = std::max(most, p);
    const Vec2 arm = at - centre;
    twice_area += geometry::cross(arm, before);  // clockwise
    before = arm;
  }
  if (most <= 0.0)
    return true;
  if (least < 0.0)
    return false;
  const WaterTable& table = water_.table;
  const double area = 0.5 * twice_area;
  result.force = table.gamma * area * (table.up - straight.slope * across_);
  result.sums[0] = result.sums[3] = -area * table_pressure(straight, centre);
  result.acts = true;
  return true;
}

BlockWater WaterNow::on_block(const Blocks& blocks, int b) const {
  BlockWater result;
  const bool own = has_own_sides(blocks, b);
  if (!own && (water_.table.none() || under_one_part(blocks, b, result)))
    return result;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
    add_side(blocks, c,
             on_side(blocks.corner.col(c), blocks.corner.col(blocks.next[c]),
                     blocks.joint[c]),
             result);
  return result;
}

void WaterNow::forces_on(const Blocks& blocks, Eigen::Matrix2Xd& forces) const {
  forces.setZero(2, blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b))
      forces.col(b) = on_block(blocks, b).force;
}

}  // namespace blocks
