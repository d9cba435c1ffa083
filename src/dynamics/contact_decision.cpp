#include "dynamics/contact_decision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Whether a point is inside the convex block, up to the slack.
bool inside(const Blocks& blocks, const Vec2& point, int block) {
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e)
    if (!geometry::near_or_inside(point, blocks.corner.col(e),
                                  blocks.corner.col(blocks.next[e])))
      return false;
  return true;
}

/// Rules 9, 10, 12 and (20) for one record. Of a convex block, the corner is known to
/// be inside: "between" is then asked of the block, not of the edge
/// (docs/departures.md).
inline bool admissible(const Blocks& blocks, int c, int edge, int edge_block) {
  const Vec2 corner = blocks.corner.col(c);
  const Vec2 p1 = blocks.corner.col(edge), p2 = blocks.corner.col(blocks.next[edge]);
  const Vec2 centroid = blocks.centroid.col(edge_block);
  return (blocks.convex[edge_block]
              ? geometry::within_depth(corner, centroid, p1, p2)
              : geometry::in_reach_of_edge(corner, centroid, p1, p2)) &&
         geometry::faces_edge(corner, blocks.corner.col(blocks.previous[c]), p1, p2) &&
         geometry::faces_edge(corner, blocks.corner.col(blocks.next[c]), p1, p2);
}

bool nearer(const Blocks& blocks, int c, int edge, int other) {
  return geometry::compare_depth(blocks.corner.col(c), blocks.corner.col(edge),
                                 blocks.corner.col(blocks.next[edge]),
                                 blocks.corner.col(other),
                                 blocks.corner.col(blocks.next[other])) < 0;
}

/// The two admissible records with the least depths, -1: none.
struct Nearest {
  int record = -1, next = -1;
};

Nearest nearest_edges(const Blocks& blocks, const Contacts& contacts,
                      const ContactGroup& group) {
  const int c = contacts.corner[group.first], block = group.edge_block;
  Nearest found;
  if (blocks.convex[block] && !inside(blocks, blocks.corner.col(c), block))
    return found;
  const auto precedes = [&](int i, int other) {
    return other < 0 || nearer(blocks, c, contacts.edge[i], contacts.edge[other]);
  };
  for (int i = group.first; i < group.last; ++i) {
    if (!admissible(blocks, c, contacts.edge[i], block))
      continue;
    if (precedes(i, found.record))
      found.next = found.record, found.record = i;
    else if (precedes(i, found.next))
      found.next = i;
  }
  return found;
}

Vec2 unit_along(const Blocks& blocks, int edge) {
  return (blocks.corner.col(blocks.next[edge]) - blocks.corner.col(edge)).normalized();
}

/// Whether a third block shields the nearest edge from this corner itself.
bool covered(const Blocks& blocks, const Contacts& contacts,
             const ContactGroups& groups, const ContactGroup& group,
             const Nearest& found) {
  const int c = contacts.corner[group.first];
  const Vec2 corner = blocks.corner.col(c);
  const int e = contacts.edge[found.record], f = contacts.edge[found.next];
  const Vec2 out = unit_along(blocks, e), other = unit_along(blocks, f);
  const double depth = geometry::cross(corner - Vec2(blocks.corner.col(f)), other);
  if (!(depth <= shield_reach(blocks, group.edge_block)))
    return false;
  const Vec2 push = depth * Vec2(-out.y(), out.x());
  for (int k = groups.first_of_corner[c]; k < groups.first_of_corner[c + 1]; ++k) {
    const int third = groups.all[groups.by_corner[k]].edge_block;
    if (third != group.edge_block && blocks.convex[third] &&
        depth <= shield_reach(blocks, third) &&
        (inside(blocks, corner + push, third) || inside(blocks, corner - push, third)))
      return true;
  }
  return false;
}

/// The same for the corner of the edge's block that lies in this corner's block.
bool partner_covered(const Blocks& blocks, const Contacts& contacts,
                     const ContactGroups& groups, const ContactGroup& group,
                     const Nearest& found) {
  const int e = contacts.edge[found.record], f = contacts.edge[found.next];
  const int partner = blocks.next[e] == f ? f : blocks.next[f] == e ? e : -1;
  if (partner < 0)
    return false;
  for (int k = groups.first_of_corner[partner]; k < groups.first_of_corner[partner + 1];
       ++k) {
    const ContactGroup& its = groups.all[groups.by_corner[k]];
    if (its.edge_block != group.corner_block)
      continue;
    // of its two edges the one that faces ours, though it may be the deeper one
    Nearest faced = nearest_edges(blocks, contacts, its);
    if (faced.next < 0)
      return false;
    const Vec2 ours = unit_along(blocks, e);
    if (ours.dot(unit_along(blocks, contacts.edge[faced.next])) <
        ours.dot(unit_along(blocks, contacts.edge[faced.record])))
      std::swap(faced.record, faced.next);
    return covered(blocks, contacts, groups, its, faced);
  }
  return false;
}

}  // namespace

int acting_record(const Blocks& blocks, const Contacts& contacts,
                  const ContactGroups& groups, const ContactGroup& group) {
  const Nearest found = nearest_edges(blocks, contacts, group);
  if (found.record < 0)
    return -1;
  const int edge = contacts.edge[found.record];
  if (geometry::overlap_sign(blocks.corner.col(contacts.corner[group.first]),
                             blocks.corner.col(edge),
                             blocks.corner.col(blocks.next[edge])) <= 0)
    return -1;
  if (found.next >= 0 && (covered(blocks, contacts, groups, group, found) ||
                          partner_covered(blocks, contacts, groups, group, found)))
    return found.next;
  return found.record;
}

double shield_reach(const Blocks& blocks, int block) {
  double least = std::numeric_limits<double>::max();
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e)
    least = std::min(
        least,
        Vec2(blocks.corner.col(blocks.next[e]) - blocks.corner.col(e)).squaredNorm());
  return 0.01 * std::sqrt(least);
}

}  // namespace blocks::dynamics
