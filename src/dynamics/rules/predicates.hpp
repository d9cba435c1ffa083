// The predicates that the contact rule asks: the exact ones of every run, and the same
// ones with room for motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/contact_predicates.hpp"
#include "geometry/covered_side.hpp"

namespace blocks::dynamics {

using geometry::Vec2;

/// Exact for the stored doubles; laws in geometry/contact_predicates.hpp. Every policy
/// of PairRule has these members.
struct ExactPredicates {
  static constexpr bool entry = true;          ///< an axis has to be entered
  static constexpr bool crossing = true;       ///< also where sides cross
  static constexpr bool covered_sides = true;  ///< closed joints hide axes
  static constexpr bool faces = true;          ///< two faces act with all four ends
  static constexpr bool has_room = false;      ///< for motion (PredicatesWithRoom)

  /// [L] For motion.
  static double room() { return 0.0; }
  static double room_of_neighbours() { return 0.0; }
  static bool narrow_room_of_neighbours() { return false; }

  /// [L] The overlap, for `depth_sign` and to compare depths.
  static geometry::filter::Estimate depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                          double per_length) {
    return geometry::filter::depth(c, p1, p2, per_length);
  }
  static int depth_sign(const geometry::filter::Estimate& depth, const Vec2& c,
                        const Vec2& p1, const Vec2& p2) {
    if (depth.positive())
      return 1;
    return depth.negative() ? -1 : geometry::overlap_sign(c, p1, p2);
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::near_or_inside(c, p1, p2);
  }
  /// Not inside.
  static bool may_be_outside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2) <= 0;
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::between(c, p1, p2);
  }
  static bool well_between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::well_between(c, p1, p2);
  }
  static bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
    return geometry::edges_face(p1, p2, q1, q2);
  }
  static int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    return geometry::turn_sign(p1, p2, q1, q2);
  }
  static int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2,
                            const Vec2& d, const Vec2& q1, const Vec2& q2) {
    return geometry::compare_depths(c, p1, p2, d, q1, q2);
  }
  static int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                            const Vec2& q2, const Vec2& r1, const Vec2& r2) {
    return geometry::compare_slopes(p1, p2, q1, q2, r1, r2);
  }
  /// Whether the side p2 q of a convex part runs on in line with the side p1 p2: either
  /// far corner is within the slack of the other side's line.
  static bool in_line(const Vec2& p1, const Vec2& p2, const Vec2& q) {
    return (p2 - p1).dot(q - p2) > 0.0 && geometry::near_or_inside(q, p2, p1) &&
           geometry::near_or_inside(p1, q, p2);
  }
  /// The outline of a block, clockwise, turns inwards at corner c.
  static bool re_entrant(const Vec2& before, const Vec2& c, const Vec2& after) {
    return geometry::overlap_sign(after, before, c) < 0;
  }
  static geometry::Cover covering(const geometry::SideEnd& end, geometry::Outline other,
                                  std::span<const geometry::Outline> neighbours) {
    return geometry::covering(end, other, neighbours);
  }
};

/// The same answers as long as no difference of two corners, or of a corner and a
/// centroid, changes by more than `room`: a value counts only if it is farther from
/// zero than its rounding error and what the motion may add together. If one is not,
/// the answer is in doubt. With v and w such differences, |v x w| and |v . w| change by
/// at most room (|v| + |w| + room); lengths are bounded from above by sums of
/// components.
class PredicatesWithRoom {
 public:
  static constexpr bool entry = true, crossing = true, covered_sides = true,
                        faces = true, has_room = true;

  PredicatesWithRoom(double room, double of_neighbours)
      : room_((1.0 + 1e-9) * room),
        of_neighbours_((1.0 + 1e-9) * std::max(room, of_neighbours)) {}

  /// Whether an answer since the last reset was in doubt.
  bool is_in_doubt() const { return in_doubt_; }
  /// Whether an answer depended on where neighbours are.
  bool asked_neighbours() const { return asked_neighbours_; }
  void forget_doubt() { in_doubt_ = false; }

  /// [L] The bound contains what motion may add. With v = c - p1 and the normal n of a
  /// side of length l, v . n changes by at most room + (|v| + room) |change of n|, and
  /// n by at most room / (l - room).
  geometry::filter::Estimate depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                   double per_length) const {
    const geometry::filter::Estimate d = geometry::filter::depth(c, p1, p2, per_length);
    const double turning = room_ * per_length < 1.0
                               ? room_ * per_length / (1.0 - room_ * per_length)
                               : std::numeric_limits<double>::infinity();
    return {d.value,
            d.bound + (1.0 + 1e-9) * (room_ + (size(p1, c) + room_) * turning)};
  }
  int depth_sign(const geometry::filter::Estimate& depth, const Vec2&, const Vec2&,
                 const Vec2&) {
    in_doubt_ = in_doubt_ || !(depth.positive() || depth.negative());
    return depth.value > 0.0 ? 1 : -1;
  }
  /// Never in doubt: true unless the corner stays inside.
  bool may_be_outside(const Vec2& c, const Vec2& p1, const Vec2& p2) const {
    const auto d = geometry::filter::overlap(c, p1, p2);
    return !(d.value > d.bound + (1.0 + 1e-9) * change(size(p1, c), size(p1, p2)));
  }
  /// Never in doubt: false unless a corner with this depth stays outside by more than
  /// the slack.
  bool stays_apart(const geometry::filter::Estimate& depth, const Vec2& p1,
                   const Vec2& p2) const {
    const double slack = geometry::contact_slack * (size(p1, p2) + room_);
    return depth.value < -(depth.bound + (1.0 + 1e-9) * slack);
  }
  bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return between_ends(c, p1, p2, geometry::contact_slack);
  }
  bool well_between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return between_ends(c, p1, p2, -geometry::contact_slack);
  }
  /// By the sine: near 180 degrees the cosine of (20) tells little.
  bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    constexpr double sine_of_10_degrees = 0.17364817766693033;
    const Vec2 e = p2 - p1, f = q2 - q1;
    const double of_e = e.norm(), of_f = f.norm(), product = of_e * of_f;
    const double changes = (1.0 + 1e-9) * change(of_e, of_f) + 1e-12 * product;
    const double sine = std::abs(geometry::cross(e, f)), cosine = e.dot(f);
    const double limit = sine_of_10_degrees * product;
    const bool face = cosine < 0.0 && sine <= limit;
    // the limit itself changes by a part of what the sine does
    const bool surely_face = cosine < -changes && sine + 1.2 * changes < limit;
    const bool surely_not = cosine > changes || sine - 1.2 * changes > limit;
    in_doubt_ = in_doubt_ || !(surely_face || surely_not);
    return face;
  }
  /// A part keeps its shape, so its motion does not matter. Sides that may be in line
  /// are left in doubt.
  bool in_line(const Vec2& p1, const Vec2& p2, const Vec2& q) {
    const Vec2 e = p2 - p1, g = q - p2;
    const double slack = 2.0 * geometry::contact_slack;
    in_doubt_ = in_doubt_ || (e.dot(g) > 0.0 &&
                              std::abs(geometry::cross(e, g)) <=
                                  slack * std::min(e.squaredNorm(), g.squaredNorm()));
    return false;
  }
  bool re_entrant(const Vec2& before, const Vec2& c, const Vec2& after) {
    const Vec2 e = c - before, g = after - c;
    const double turn = geometry::cross(g, e);
    in_doubt_ = in_doubt_ ||
                std::abs(turn) <= 2.0 * geometry::contact_slack * e.norm() * g.norm();
    return turn < 0.0;
  }
  int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    return sure(geometry::filter::turn(p1, p2, q1, q2),
                change(size(p1, p2), size(q1, q2)));
  }
  int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2,
                     const Vec2& r1, const Vec2& r2) {
    const double p = size(p1, p2), q = size(q1, q2), r = size(r1, r2);
    return sure(geometry::filter::slope_difference(p1, p2, q1, q2, r1, r2),
                change(p, q) * (r + room_) + p * q * room_ +
                    change(p, r) * (q + room_) + p * r * room_);
  }
  void doubt() { in_doubt_ = true; }
  double room() const { return room_; }
  /// No corner of another block moves by more against those of the two, [L]. First much
  /// is tried.
  double room_of_neighbours() {
    asked_neighbours_ = true;
    return of_neighbours_;
  }
  /// Less than that; false: it cannot be less.
  bool narrow_room_of_neighbours() {
    const bool can = of_neighbours_ > room_;
    of_neighbours_ = room_;
    return can;
  }

 private:
  int sure(const geometry::filter::Estimate& d, double changes) {
    const double bound = d.bound + (1.0 + 1e-9) * changes;
    in_doubt_ = in_doubt_ || !(std::abs(d.value) > bound);
    return d.value > 0.0 ? 1 : -1;
  }
  bool between_ends(const Vec2& c, const Vec2& p1, const Vec2& p2, double part) {
    const double e = size(p1, p2);
    return sure(geometry::filter::between(c, p1, p2, part),
                change(size(p1, c), e) + 2.0 * change(e, e)) > 0;
  }
  static double size(const Vec2& from, const Vec2& to) {
    return std::abs(to.x() - from.x()) + std::abs(to.y() - from.y());
  }
  double change(double v, double w) const { return room_ * (v + w + room_); }

  double room_, of_neighbours_;
  bool in_doubt_ = false, asked_neighbours_ = false;
};

}  // namespace blocks::dynamics
