#include "dynamics/preparation/faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/contact_constants.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

double depth_below(const Blocks& blocks, const CornerOnEdge& at) {
  const Vec2 start = blocks.corner.col(at.edge);
  const Vec2 side = Vec2(blocks.corner.col(blocks.next[at.edge])) - start;
  return geometry::cross(Vec2(blocks.corner.col(at.corner)) - start, side) /
         side.norm();
}

Face::Face(const Blocks& blocks, int e, int f)
    : blocks_(blocks), e_(e), f_(f), start_(at(e)), along_(at(blocks.next[e]) - start_),
      length_(along_.norm()) {
  along_ /= length_;
}

bool Face::is_flush(double tolerance, double min) const {
  const Vec2 other = at(blocks_.next[f_]) - at(f_);
  return along_.dot(other) <= -geometry::face_cosine * other.norm() &&
         high() - low() > min && end(true, slack(tolerance)).gap <= tolerance &&
         end(false, slack(tolerance)).gap <= tolerance;
}

double Face::slack(double tolerance) const {
  return std::max(tolerance, geometry::contact_slack * length_);
}

FaceEnd Face::end(bool at_end_of_e, double slack) const {
  // f runs backwards: its start is at the end of e.
  const int of_e = at_end_of_e ? blocks_.next[e_] : e_;
  const int of_f = at_end_of_e ? f_ : blocks_.next[f_];
  const double here = at_end_of_e ? length_ : 0.0, there = position(of_f);
  const double beyond = at_end_of_e ? there - here : here - there;
  FaceEnd found;
  const auto add = [&](int corner, int edge) {
    found.records[static_cast<std::size_t>(found.count++)] = {corner, edge};
    found.gap = std::max(found.gap, std::abs(depth(corner, edge)));
  };
  if (beyond <= slack)
    add(of_f, e_);
  if (beyond >= -slack)
    add(of_e, f_);
  return found;
}

double Face::low() const { return std::max(0.0, position(blocks_.next[f_])); }
double Face::high() const { return std::min(length_, position(f_)); }
double Face::depth(int corner, int edge) const {
  return depth_below(blocks_, {corner, edge});
}

}  // namespace blocks::dynamics
