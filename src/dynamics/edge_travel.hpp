// For how long one question about a corner and an edge keeps its answer: bounds on the
// motion of their blocks against each other (contact_certainty.hpp).
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A corner seen from an edge.
struct EdgeView {
  Vec2 along, from_first;   ///< [L] the edge; first corner of the edge to the corner
  double length, distance;  ///< [L] of the two

  EdgeView(const Blocks& blocks, int c, int edge)
      : along(blocks.corner.col(blocks.next[edge]) - blocks.corner.col(edge)),
        from_first(blocks.corner.col(c) - blocks.corner.col(edge)),
        length(along.norm()), distance(from_first.norm()) {}
  double overlap_product() const { return geometry::cross(from_first, along); }
  double depth() const { return overlap_product() / length; }  ///< [L]
  double slack() const { return geometry::contact_slack * length * length; }
};

/// Relative motion during which a product of two differences of lengths r and s keeps
/// its sign; has that sign. Zero where round-off could matter.
inline double sign_travel(double product, double r, double s) {
  const double sum = r + s, travel = product / (1.5 * sum);
  return std::abs(travel) > 1e-9 * sum ? travel : 0.0;
}

/// Of (20) for one of the corner's own edges.
inline double facing_travel(const Blocks& blocks, int c, int neighbour,
                            const EdgeView& edge) {
  constexpr double sine = 0.17364817766693036;  // sin 10 degrees
  const Vec2 own = blocks.corner.col(neighbour) - blocks.corner.col(c);
  const double length = own.norm();
  const double value = geometry::cross(edge.along, own) + sine * edge.length * length;
  return sign_travel(value / (1.0 + sine), edge.length, length);
}

/// A lead that falls by at most twice `growth` for each length of travel is not lost.
inline double lead_travel(double lead, double growth, double distances) {
  const double travel = 0.4 * lead / growth;
  return travel > 1e-9 * distances ? travel : 0.0;
}
/// The same of the depth below one edge over that below another.
inline double lead_travel(const EdgeView& p, const EdgeView& q, double lead) {
  return lead_travel(lead, 1.0 + p.distance / p.length + q.distance / q.length,
                     p.distance + q.distance);
}

/// The corner stays on its side of an edge, up to the slack or not: positive when
/// inside. Asked most often: without roots, for lengths may be taken for longer.
inline double side_travel(const Blocks& blocks, int corner, int edge,
                          bool slack = true) {
  const Vec2 p1 = blocks.corner.col(edge);
  const Vec2 along = blocks.corner.col(blocks.next[edge]) - p1;
  const Vec2 from_first = blocks.corner.col(corner) - p1;
  const double product = geometry::cross(from_first, along) +
                         (slack ? geometry::contact_slack * along.squaredNorm() : 0.0);
  return sign_travel(product, along.lpNorm<1>(), from_first.lpNorm<1>());
}

/// The corner stays beyond an end of the edge: positive when between.
inline double between_travel(const Blocks& blocks, int c, int edge) {
  const EdgeView view(blocks, c, edge);
  const Vec2 to_second = view.along - view.from_first;
  return std::min(sign_travel(view.from_first.dot(view.along) + view.slack(),
                              view.length, view.distance),
                  sign_travel(to_second.dot(view.along) + view.slack(), view.length,
                              to_second.norm()));
}

/// How much more than relative_motion a difference of two corners may change, [L]: each
/// stored corner is rounded, half a unit in the last place of its coordinates.
inline double roundoff(const Blocks& blocks, int corner, int block) {
  return 0x1p-48 * (blocks.corner.col(corner).lpNorm<Eigen::Infinity>() +
                    blocks.centroid.col(block).lpNorm<Eigen::Infinity>());
}

}  // namespace blocks::dynamics
