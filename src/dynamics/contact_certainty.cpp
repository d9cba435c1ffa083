#include "dynamics/contact_certainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/contact_decision.hpp"
#include "dynamics/edge_travel.hpp"
#include "dynamics/meeting_travel.hpp"
#include "dynamics/third_travel.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Positive: the record stays admissible for this travel. Negative: it stays
/// inadmissible, for the sake of an inequality that fails by more than `enough`, or of
/// that which fails by most.
double admissible_travel(const Blocks& blocks, const Contacts& contacts, int i,
                         double enough) {
  const int c = contacts.corner[i];
  const int block = blocks.corner_block[contacts.edge[i]];
  const EdgeView edge(blocks, c, contacts.edge[i]);
  double travel = facing_travel(blocks, c, blocks.previous[c], edge);
  if (travel < -enough)
    return travel;
  travel = std::min(travel, facing_travel(blocks, c, blocks.next[c], edge));
  if (travel < -enough)
    return travel;
  const Vec2 from_centroid = blocks.corner.col(c) - blocks.centroid.col(block);
  const double depth = geometry::cross(from_centroid, edge.along);
  return std::min(travel, sign_travel(-depth, edge.length, from_centroid.norm()));
}

/// Third blocks are asked only where nothing is certain for `enough` without them, for
/// they move as they like.
struct Thirds {
  const ContactGroups& groups;
  double enough;
  ThirdsAway away;

  /// Makes a travel as long as `other` for as long as no third block goes on with the
  /// surface below corner c.
  void lengthen(double& travel, double other, const Blocks& blocks, int c,
                int surface) {
    if (travel >= enough || other <= travel)
      return;
    const ThirdsAway::Place place{c, surface};
    if ((away.contains(place) || thirds_away(blocks, groups, place)) && away.add(place))
      travel = other;
  }
};

/// The corner stays deeper below the edge of record i than below that of record j, and
/// too deep for a shield, or nothing is hidden. Worth no more than `most`.
double deeper_travel(const Blocks& blocks, const Contacts& contacts, int i, int j,
                     double most, Thirds& thirds) {
  const int c = contacts.corner[i], surface = contacts.edge[i];
  const EdgeView p(blocks, c, surface), q(blocks, c, contacts.edge[j]);
  const double deeper = lead_travel(p, q, p.depth() - q.depth());
  double travel =
      std::min(deeper, lead_travel(p, q, p.depth() - 1.01 * shielded_depth * p.length));
  if (travel < most)
    thirds.lengthen(travel, deeper, blocks, c, surface);
  return travel;
}

/// The lower end of an edge is, as long as it is the lower one, the toe of its block
/// (ClosedJoint::toe_of).
double toe_travel(const Blocks& blocks, int toe, int surface) {
  const EdgeView view(blocks, toe, surface);
  return std::min(facing_travel(blocks, toe, blocks.previous[toe], view),
                  facing_travel(blocks, toe, blocks.next[toe], view));
}

/// It is too far from the side for a joint there.
double far_travel(const Blocks& blocks, int toe, int side, int surface) {
  const EdgeView from_side(blocks, toe, side), from_surface(blocks, toe, surface);
  const double reach = (shielded_way + shielded_depth) * from_surface.length;
  const double lead = std::abs(from_side.depth()) - 1.01 * reach;
  return lead_travel(lead, 1.0 + 2.0 * from_side.distance / from_side.length,
                     from_side.distance);
}

/// No closed joint hides corner c from edge e (ClosedJoint::hides_corner), for this
/// travel at least: the edge runs along the surface, or the toe of its block lies too
/// deep, or too far from the joint, or there is none. Worth no more than `enough`.
double seen_travel(const Blocks& blocks, int c, int e, double enough, Thirds& thirds) {
  const int first = e, second = blocks.next[e], before = blocks.previous[c];
  const Vec2 flank = blocks.corner.col(second) - blocks.corner.col(first);
  const double flank_length = flank.norm();
  double travel = enough;
  for (const auto& [side, surface] : {std::pair(before, c), {c, before}}) {
    const Vec2 along =
        blocks.corner.col(blocks.next[surface]) - blocks.corner.col(surface);
    const double length = along.norm();
    const double flat = 0.99 * least_flank * flank_length * length -
                        std::abs(geometry::cross(flank, along));
    double seen = sign_travel(flat / (1.0 + least_flank), flank_length, length);
    if (seen < travel) {
      const EdgeView p(blocks, first, surface), q(blocks, second, surface);
      const bool forward = q.overlap_product() > p.overlap_product();
      const EdgeView& lower = forward ? q : p;
      seen = std::max(seen,
                      lead_travel(lower.depth() - 1.01 * shielded_depth * length,
                                  1.0 + 2.0 * lower.distance / length, lower.distance));
      if (seen < travel) {
        const int toe = forward ? second : first;
        const double stays_toe =
            std::min(lead_travel(p, q, std::abs(q.depth() - p.depth())),
                     toe_travel(blocks, toe, surface));
        seen =
            std::max(seen, std::min(stays_toe, far_travel(blocks, toe, side, surface)));
        if (seen < travel)
          thirds.lengthen(seen, stays_toe, blocks, toe, surface);
      }
    }
    travel = std::min(travel, seen);
  }
  return travel;
}

/// The edge beside `side`, of which alone the corner is outside, certainly does not act
/// for the sake of a crossing (crossing_sides.hpp): one condition fails by `enough`, or
/// by this much.
double no_crossing_travel(const Blocks& blocks, int c, int edge, bool after,
                          double enough) {
  const CrossingSides s(blocks, c, edge, after);
  const EdgeView view(blocks, c, edge);
  double travel = -facing_travel(blocks, c, blocks.previous[c], view);
  if (travel < enough)
    travel = std::max(travel, -facing_travel(blocks, c, blocks.next[c], view));
  if (travel < enough)
    travel = std::max(travel, side_travel(blocks, s.vertex, s.own));
  if (travel < enough)
    travel = std::max(travel, -between_travel(blocks, c, edge));
  if (travel < enough)
    travel = std::max({travel, -side_travel(blocks, s.own_far, s.side),
                       -side_travel(blocks, s.vertex_far, s.own)});
  return travel;
}

/// Which of the questions that keep these sides apart has its answer for longest, at
/// least as long as round-off does not matter; 0: none.
unsigned best_apart(const Blocks& blocks, const CrossingSides& sides) {
  unsigned best = 0;
  double longest = 0.0;
  for (unsigned number = 1; number <= CrossingSides::most_apart; ++number) {
    const auto [corner, edge, outside] = sides.apart(number);
    const double travel = side_travel(blocks, corner, edge);
    if ((outside ? -travel : travel) > longest)
      longest = outside ? -travel : travel, best = number;
  }
  return best;
}

/// The same for both neighbours of `side`.
double no_crossing_beside(const Blocks& blocks, int c, int side, double enough) {
  return std::min(no_crossing_travel(blocks, c, blocks.previous[side], true, enough),
                  no_crossing_travel(blocks, c, blocks.next[side], false, enough));
}

/// Distance of a point from the segment from p by `along`.
double distance(const Vec2& point, const Vec2& p, const Vec2& along) {
  const double s = std::clamp((point - p).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - p - s * along).norm();
}

/// Distance of two edges; 0 where they cross.
double distance_of_edges(const Blocks& blocks, int e, int f) {
  const Vec2 p = blocks.corner.col(e), q = blocks.corner.col(f);
  const Vec2 p2 = blocks.corner.col(blocks.next[e]);
  const Vec2 q2 = blocks.corner.col(blocks.next[f]);
  const auto side = [&](const Vec2& point, const Vec2& from, const Vec2& to) {
    return geometry::overlap_sign(point, from, to);
  };
  if (side(p, q, q2) != side(p2, q, q2) && side(q, p, p2) != side(q2, p, p2))
    return 0.0;
  return std::min({distance(p, q, q2 - q), distance(p2, q, q2 - q),
                   distance(q, p, p2 - p), distance(q2, p, p2 - p)});
}

/// Relative motion that certainly passes before a corner outside of a block of any
/// shape is as near to it as the slack, or one of its own edges crosses it; or 0. Every
/// point of an edge moves by less than the farther of its ends.
double travel_before_outline(const Blocks& blocks, int corner, int block) {
  const Vec2 c = blocks.corner.col(corner);
  if (ReentrantBlock<ExactRules>(blocks, block).holds(c))
    return 0.0;
  double nearest = std::numeric_limits<double>::max(), longest = 0.0;
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e) {
    longest = std::max(longest, EdgeView(blocks, corner, e).length);
    for (const int own : {corner, blocks.previous[corner]})
      nearest = std::min(nearest, distance_of_edges(blocks, own, e));
  }
  return std::max(0.0, 0.8 * nearest - 16.0 * geometry::contact_slack * longest);
}

/// side_travel of the edge that the corner is farthest out of, or least far inside, and
/// of the next two.
struct Sides {
  static constexpr double forever = std::numeric_limits<double>::max();
  int edge = -1, next_edge = -1;
  double least = forever, next = forever, third = forever;
  bool asks = false;  ///< whether the edge comes through, or some side crosses

  /// As long as the corner stays there in the block.
  Sides(int place, bool with_questions) : edge(place), asks(with_questions) {
    if (place != PlaceInBlock<ExactRules>::none)
      least = -forever;
    if (place == PlaceInBlock<ExactRules>::several)
      next = -forever;
  }
  Sides(const Blocks& blocks, int corner, int block) {
    for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e) {
      const double travel = side_travel(blocks, corner, e);
      if (travel < least) {
        third = next, next = least, next_edge = edge;
        least = travel, edge = e;
      } else if (travel < next) {
        third = next, next = travel, next_edge = e;
      } else {
        third = std::min(third, travel);
      }
    }
  }
};

/// No record acts: the corner stays outside of two edges, or of one that no side
/// crosses; or it is inside, and all stay inadmissible.
double idle_travel(const Blocks& blocks, const Contacts& contacts,
                   const ContactGroup& group, const Sides& sides) {
  if (sides.least < 0.0) {
    const double outside = std::max(-sides.next, 0.0);
    if (-sides.least <= outside)
      return outside;
    const int c = contacts.corner[group.first];
    return std::max(
        outside,
        sides.asks ? -sides.least
                   : std::min(-sides.least,
                              no_crossing_beside(blocks, c, sides.edge, -sides.least)));
  }
  const int first = group.first;
  double travel = EdgeView(blocks, contacts.corner[first], contacts.edge[first]).length;
  for (int i = group.first; i < group.last() && travel > 0.0; ++i)
    travel = std::min(travel, -admissible_travel(blocks, contacts, i, travel));
  return std::max(travel, 0.0);
}

/// Record i acts if its corner is inside its edge, and nothing else does. Of a convex
/// block.
double candidate_travel(const Blocks& blocks, const Contacts& contacts,
                        const ContactGroup& group, const Sides& sides, int i,
                        Thirds& thirds) {
  const int c = contacts.corner[i], edge = contacts.edge[i];
  double travel = edge == sides.edge ? sides.next : sides.least;
  if (travel > 0.0)
    travel = std::min(travel, admissible_travel(blocks, contacts, i, 0.0));
  if (travel > 0.0 && !sides.asks)
    travel = std::min(travel, through_travel(blocks, c, edge, travel));
  for (int j = group.first; j < group.last() && travel > 0.0; ++j) {
    if (j == i)
      continue;
    double others = -admissible_travel(blocks, contacts, j, travel);
    if (others < travel)
      if (const double deeper = deeper_travel(blocks, contacts, j, i, travel, thirds);
          deeper > others)
        others = std::max(
            others,
            std::min(deeper, meeting_inside_travel(blocks, c, edge, false, travel)));
    travel = std::min(travel, others);
  }
  if (travel > 0.0)
    travel = seen_travel(blocks, c, edge, travel, thirds);
  if (travel <= 0.0 || edge != sides.edge || sides.least >= travel || sides.asks)
    return travel;
  // outside of this edge only, it could be a crossing
  return std::min(travel,
                  std::max(sides.least, no_crossing_beside(blocks, c, edge, travel)));
}

/// The candidate that is certain for longest, or that there is none. Of a convex block.
Certainty best_candidate(const Blocks& blocks, const Contacts& contacts,
                         const ContactGroups& groups, const ContactGroup& group,
                         const Sides& sides, double enough) {
  const int c = contacts.corner[group.first];
  Certainty best{.travel = idle_travel(blocks, contacts, group, sides), .away = {}};
  // far off: not worth a closer look
  if (best.travel > 0.02 * EdgeView(blocks, c, contacts.edge[group.first]).length)
    return best;
  for (int i = group.first; i < group.last(); ++i) {
    Thirds thirds{groups, enough, {}};
    const double travel = candidate_travel(blocks, contacts, group, sides, i, thirds);
    if (travel > best.travel)
      best = {.candidate = i, .travel = travel, .away = thirds.away};
  }
  return best;
}

Certainty certainty_of_rules(const Blocks& blocks, const Contacts& contacts,
                             const ContactGroups& groups, const ContactGroup& group,
                             int block, double enough) {
  const int c = contacts.corner[group.first];
  if (!blocks.convex[block])
    return {.travel = travel_before_outline(blocks, c, block), .away = {}};
  const Certainty anywhere =
      best_candidate(blocks, contacts, groups, group, Sides(blocks, c, block), enough);
  if (anywhere.travel > enough || blocks.corners_of(block) > ContactGroup::most_edges)
    return anywhere;
  const int place =
      PlaceInBlock<ExactRules>(blocks).outside_of(blocks.corner.col(c), block);
  const double most = 8.0 * enough;
  Certainty best = anywhere;
  for (const bool asks : {false, true}) {
    Certainty there =
        best_candidate(blocks, contacts, groups, group, Sides(place, asks), enough);
    there.travel = std::min(there.travel, most);
    if (there.travel <= 2.0 * best.travel)
      continue;
    best = there, best.asks = asks;
    best.place = place < 0 ? place : place - blocks.first_corner[block];
    if (best.travel > enough)
      break;
  }
  return best;
}

}  // namespace

Certainty certainty(const Blocks& blocks, const Contacts& contacts,
                    const ContactGroups& groups, const ContactGroup& group, int block,
                    double enough) {
  Certainty known = certainty_of_rules(blocks, contacts, groups, group, block, enough);
  known.travel -= roundoff(blocks, contacts.corner[group.first], block);
  return known.travel > 0.0 ? known : Certainty{};
}

ConditionTravel condition_travel(const Blocks& blocks, const Contacts& contacts,
                                 const ContactGroup& group, int block, double enough) {
  using Place = PlaceInBlock<ExactRules>;
  const int c = contacts.corner[group.first];
  const int first = blocks.first_corner[block];
  const int place = group.place() < 0 ? group.place() : first + group.place();
  const Sides sides(blocks, c, block);
  // how far the corner is from passing each of the two edges, and the others
  constexpr double forever = std::numeric_limits<float>::max() / 4.0F;
  std::array<double, 2> margin = {0.0, 0.0};
  double others = 0.0;
  if (place == Place::none)
    margin = {sides.least, sides.next}, others = sides.third;
  else if (place == Place::several)
    margin = {-sides.least, -sides.next}, others = forever;
  else if (place == sides.edge)  // inside of all others
    margin = {-sides.least, sides.next}, others = sides.third;
  ConditionTravel found;
  found.travel = std::min({margin[0], margin[1], others});
  found.rest = others;
  const std::array edges = {sides.edge - first, sides.next_edge - first};
  for (const int i : {0, 1})
    if (margin[i] <= enough)
      found.watch.edges[i] = edges[i];
    else
      found.rest = std::min(found.rest, margin[i]);
  if (group.asks && found.rest > 0.0 && place >= 0) {
    for (const bool after : {false, true}) {
      const int beside = after ? blocks.next[place] : blocks.previous[place];
      const double apart = no_crossing_travel(blocks, c, beside, !after, found.rest);
      found.travel = std::min(found.travel, apart);
      if (apart <= enough)
        found.watch.apart[after] =
            best_apart(blocks, CrossingSides(blocks, c, beside, !after));
      if (found.watch.apart[after] == 0)
        found.rest = std::min(found.rest, apart);
    }
  } else if (group.asks && found.rest > 0.0 && place == Place::none &&
             group.record() >= 0) {
    found.rest =
        std::min(found.rest,
                 through_travel(blocks, c, contacts.edge[group.record()], found.rest));
  }
  const double rounded = roundoff(blocks, c, block);
  found.rest = std::max(0.0, found.rest - rounded);
  found.travel = std::clamp(found.travel - rounded, 0.0, found.rest);
  return found;
}

}  // namespace blocks::dynamics
