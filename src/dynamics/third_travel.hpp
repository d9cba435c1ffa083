// For how long no third block goes on where a joint ends a surface: what a closed joint
// might hide (closed_joint.hpp) is not hidden.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/closed_joint.hpp"
#include "dynamics/contact_groups.hpp"
#include "dynamics/edge_travel.hpp"

namespace blocks::dynamics {

/// The surface does not go on in a third block below the places that corner c may
/// slide to, at most 0.06 of the surface away (ClosedJoint::goes_on): it stays outside
/// of an edge there, or no edge of it runs along the surface, half as deep to twice as
/// deep. While differences of corners of the three blocks change by u, a tenth of
/// either edge at most, directions change by 2 u / L, and a depth by 1.2 u + 2 u w / L,
/// w the distance from the first corner. 0: that is open.
inline double away_travel(const Blocks& blocks, int third, int c,
                          const EdgeView& surface) {
  const Vec2 along = surface.along / surface.length;
  const double depth = surface.depth(), way = 1.01 * shielded_way * surface.length;
  double outside = 0.0, nowhere = std::numeric_limits<double>::max();
  for (int e = blocks.first_corner[third]; e < blocks.first_corner[third + 1]; ++e) {
    const EdgeView edge(blocks, c, e);
    const double below = edge.depth(), far = edge.distance / edge.length;
    const double sine = std::abs(geometry::cross(edge.along, along)) / edge.length;
    const double cosine = edge.along.dot(along) / edge.length;
    const double most = 0.1 * std::min(edge.length, surface.length);
    outside =
        std::max(outside, std::min(most, 0.8 * (-below - way * sine) /
                                             (1.5 + 2.0 * (far + way / edge.length))));
    const double slope = std::min(way, 1.01 * shielded_way * edge.length) * sine;
    const double lead =
        std::max(0.5 * depth - (below + slope), (below - slope) - 2.0 * depth);
    const double other_depth =
        0.8 * lead / (4.0 + 2.0 * far + 4.0 * surface.distance / surface.length);
    const double other_way =
        0.7 * (least_cosine - cosine) / (2.0 / surface.length + 2.0 / edge.length);
    nowhere = std::min({nowhere, most, std::max(other_depth, other_way)});
  }
  const double travel = std::max(outside, nowhere) - roundoff(blocks, c, third);
  return travel > 1e-9 * (surface.length + surface.distance) ? travel : 0.0;
}

/// Whether all blocks that are listed for the corner, but that of the surface, are
/// away.
inline bool thirds_away(const Blocks& blocks, const ContactGroups& groups,
                        const ThirdsAway::Place& place) {
  const EdgeView surface(blocks, place.corner, place.surface);
  bool away = true;
  groups.each_third(blocks, place, [&](int third) {
    away = away && away_travel(blocks, third, place.corner, surface) > 0.0;
  });
  return away;
}

}  // namespace blocks::dynamics
