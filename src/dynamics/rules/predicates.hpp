// The predicates that the contact rule asks: the exact ones of every run, and the same
// ones with room for motion.
#pragma once

#include <cmath>
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

  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2);
  }
  /// Not inside.
  static bool may_be_outside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2) <= 0;
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::near_or_inside(c, p1, p2);
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

  explicit PredicatesWithRoom(double room) : room_((1.0 + 1e-9) * room) {}

  /// Whether an answer since the last reset was in doubt.
  bool is_in_doubt() const { return in_doubt_; }
  /// Whether an answer depended on where neighbours are.
  bool asked_neighbours() const { return asked_neighbours_; }
  void forget_doubt() { in_doubt_ = false; }

  int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return sure(geometry::filter::overlap(c, p1, p2),
                change(size(p1, c), size(p1, p2)));
  }
  /// Never in doubt: true unless the corner stays inside.
  bool may_be_outside(const Vec2& c, const Vec2& p1, const Vec2& p2) const {
    const auto d = geometry::filter::overlap(c, p1, p2);
    return !(d.value > d.bound + (1.0 + 1e-9) * change(size(p1, c), size(p1, p2)));
  }
  bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const double e = size(p1, p2);
    return sure(geometry::filter::near_or_inside(c, p1, p2),
                change(size(p1, c), e) + change(e, e)) > 0;
  }
  bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return between_ends(c, p1, p2, geometry::contact_slack);
  }
  bool well_between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return between_ends(c, p1, p2, -geometry::contact_slack);
  }
  bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    const double e = size(p1, p2), f = size(q1, q2);
    // |D| <= e f and Q = |e|^2 |f|^2
    const double of_dot = change(e, f), of_e2 = change(e, e), of_f2 = change(f, f);
    return sure(geometry::filter::edges_face(p1, p2, q1, q2),
                of_dot * (2.0 * e * f + of_dot) + of_e2 * f * f + of_f2 * e * e +
                    of_e2 * of_f2) > 0;
  }
  int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    return sure(geometry::filter::turn(p1, p2, q1, q2),
                change(size(p1, p2), size(q1, q2)));
  }
  int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& d,
                     const Vec2& q1, const Vec2& q2) {
    const double p = size(p1, p2), q = size(q1, q2), a = size(p1, c) * p,
                 b = size(q1, d) * q;
    return sure(geometry::filter::depth_difference(c, p1, p2, d, q1, q2),
                change(size(p1, c), p) * (q + room_) + a * room_ +
                    change(size(q1, d), q) * (p + room_) + b * room_);
  }
  int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2,
                     const Vec2& r1, const Vec2& r2) {
    const double p = size(p1, p2), q = size(q1, q2), r = size(r1, r2);
    return sure(geometry::filter::slope_difference(p1, p2, q1, q2, r1, r2),
                change(p, q) * (r + room_) + p * q * room_ +
                    change(p, r) * (q + room_) + p * r * room_);
  }
  /// It is only asked whether anything covers, and that is in doubt if it may.
  geometry::Cover covering(const geometry::SideEnd& end, geometry::Outline other,
                           std::span<const geometry::Outline> neighbours) {
    asked_neighbours_ = true;
    in_doubt_ =
        in_doubt_ || !geometry::is_surely_uncovered(end, other, neighbours, room_);
    return {};
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

  double room_;
  bool in_doubt_ = false, asked_neighbours_ = false;
};

}  // namespace blocks::dynamics
