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

/// Calls visit for the part of a linear pressure that is above 0.
template <class Visit>
void visit_above_zero(double t0, double p0, double t1, double p1, const Visit& visit) {
  if (!(t1 > t0) || (p0 <= 0.0 && p1 <= 0.0))
    return;
  if (p0 < 0.0) {
    t0 += (t1 - t0) * (p0 / (p0 - p1));
    p0 = 0.0;
  } else if (p1 < 0.0) {
    t1 -= (t1 - t0) * (p1 / (p1 - p0));
    p1 = 0.0;
  }
  visit(t0, p0, t1, p1);
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

/// Calls visit for the part of the side from a to b on which one card acts.
template <class Visit>
void visit_line(const JointWater& water, double time, const Vec2& a, const Vec2& b,
                const Visit& visit) {
  if (water.is_dry())
    return;
  const OnLine first = on_line(water, a), second = on_line(water, b);
  double t0 = 0.0, t1 = 1.0;
  clip(first.along, second.along, 0.0, 1.0, t0, t1);
  clip(first.distance, second.distance, -water.reach, water.reach, t0, t1);
  const double passed = water.passed(time);
  const auto at = [&](double t) {
    const double along = first.along + t * (second.along - first.along);
    return passed * (water.p1 + along * (water.p2 - water.p1));
  };
  visit_above_zero(t0, at(t0), t1, at(t1), visit);
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

bool Water::has_own(const Blocks& blocks, int b) const {
  if (joints.empty())
    return false;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
    if (has_own(blocks.joint[c]))
      return true;
  return false;
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
      has_table_(!water.table.none() && !(water.table.drains && passed_ >= 1.0)),
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
  const WaterTable& table = water_.table;
  const std::vector<double>& place = table.place;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t n = place.size(), low = k == 0 ? 0 : k - 1;
  Part made;
  made.left = k == 0 ? -infinity : place[low];
  made.right = k == n || n == 1 ? infinity : place[k];
  if (k > 0 && k < n)
    made.slope = (level(k) - level(low)) / (place[k] - place[low]);
  made.point = place[low] * across_ + level(low) * table.up;
  made.gradient = table.gamma * (made.slope * across_ - table.up);
  return made;
}

double WaterNow::level_at(double s) const {
  const Part straight = part(part_at(s));
  return water_.table.up.dot(straight.point) +
         straight.slope * (s - across_.dot(straight.point));
}

template <class Visit>
void WaterNow::each_table_part(const Vec2& a, const Vec2& b, double weight,
                               const Visit& visit) const {
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
    const auto at = [&](double t) {
      return weight * straight.pressure(a + t * (b - a));
    };
    visit_above_zero(t0, at(t0), t1, at(t1), visit);
  }
}

template <class Visit>
void WaterNow::each_part(const Vec2& a, const Vec2& b, int joint,
                         const Visit& visit) const {
  double own = 0.0;  // how far the pressures of JWATER have taken the table's place
  for (const JointWater& one : water_.joints)
    if (one.joint == joint) {
      own = std::max(own, one.passed(time_));
      visit_line(one, time_, a, b, visit);
    }
  if (has_table_ && own < 1.0)
    each_table_part(a, b, 1.0 - own, visit);
}

void WaterNow::add_parts(const Vec2& a, const Vec2& b, int joint,
                         std::vector<WetPart>& parts) const {
  each_part(a, b, joint, [&](double t0, double p0, double t1, double p1) {
    parts.push_back({t0, t1, p0, p1});
  });
}

EndLoads WaterNow::on_side(const Vec2& a, const Vec2& b, int joint) const {
  EndLoads loads;
  each_part(a, b, joint, [&](double t0, double p0, double t1, double p1) {
    const double width = t1 - t0;
    // Both are integrals of functions that are not negative, so nothing cancels.
    loads.second += width * (0.5 * t0 * (p0 + p1) + width * (p0 + 2.0 * p1) / 6.0);
    loads.first +=
        width * (0.5 * (1.0 - t1) * (p0 + p1) + width * (2.0 * p0 + p1) / 6.0);
  });
  return loads;
}

/// Finds the resultant if all corners lie under, or all above, one straight part of the
/// table. The pressure is then linear over the whole block: by the theorem of Gauss,
/// the force is minus the area times its gradient, it acts at the centroid, and the
/// sums f_i x_j are minus the area times the pressure there.
bool WaterNow::under_one_part(const Blocks& blocks, int b, BlockWater& result) {
  const int begin = blocks.first_corner[b], end = blocks.first_corner[b + 1];
  // Which part is taken must not depend on the block before.
  if (const double s = across_.dot(Vec2(blocks.corner.col(begin)));
      !(last_.left <= s && s < last_.right))
    last_ = part(part_at(s));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double min = infinity, max = -infinity, left = infinity, right = -infinity;
  for (int c = begin; c < end; ++c) {
    const Vec2 at = blocks.corner.col(c);
    const double s = across_.dot(at), p = last_.pressure(at);
    left = std::min(left, s), right = std::max(right, s);
    min = std::min(min, p), max = std::max(max, p);
  }
  if (left < last_.left || right > last_.right)
    return false;
  if (max <= 0.0)
    return true;
  if (min < 0.0)
    return false;
  const auto f = blocks.gradient.col(b);  // deforms the block since creation
  const double area = blocks.area[b] * (f[0] * f[3] - f[1] * f[2]);
  result.force = -area * last_.gradient;
  result.sums[0] = result.sums[3] = -area * last_.pressure(blocks.centroid.col(b));
  result.acts = true;
  return true;
}

BlockWater WaterNow::on_block(const Blocks& blocks, int b) {
  BlockWater result;
  const bool own = water_.has_own(blocks, b);
  if (!own && (!has_table_ || under_one_part(blocks, b, result)))
    return result;
  const int begin = blocks.first_corner[b], end = blocks.first_corner[b + 1];
  if (!own) {
    // A block above all points of the table over it is dry.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right = -infinity, lowest = infinity, highest = -infinity;
    for (int c = begin; c < end; ++c) {
      const Vec2 at = blocks.corner.col(c);
      left = std::min(left, across_.dot(at)), right = std::max(right, across_.dot(at));
      lowest = std::min(lowest, water_.table.up.dot(at));
    }
    const std::size_t first = part_at(left), last = part_at(right);
    for (std::size_t k = first == 0 ? 0 : first - 1;
         k <= last && k < water_.table.place.size(); ++k)
      highest = std::max(highest, level(k));
    if (lowest >= highest)
      return result;
  }
  for (int c = begin; c < end; ++c)
    add_side(blocks, c,
             on_side(blocks.corner.col(c), blocks.corner.col(blocks.next[c]),
                     blocks.joint[c]),
             result);
  return result;
}

void WaterNow::forces_on(const Blocks& blocks, Eigen::Matrix2Xd& forces) {
  forces.setZero(2, blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b))
      forces.col(b) += on_block(blocks, b).force;
}

}  // namespace blocks
