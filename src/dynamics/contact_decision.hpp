// Which edge of a block acts on a corner (report 3.3, rules 9-12). The decision is
// written once, for any rules: the answers to its questions come from a policy, so that
// the time loop has the exact ones inlined and `blocks study` can ask others.
#pragma once

#include "dynamics/closed_joint.hpp"
#include "dynamics/contact_groups.hpp"
#include "dynamics/crossing_sides.hpp"
#include "dynamics/reentrant_block.hpp"
#include "geometry/contact_predicates.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The rules of every run: exact, with slack, (20), nearest edge and shield. A policy
/// has these members; c is a corner, p1 -> p2 an edge, laws and limits as in
/// geometry/contact_predicates.hpp.
struct ExactRules {
  static constexpr bool whole_block = true;      ///< "between" of blocks as a whole
  static constexpr bool far_edges_meet = true;   ///< far edges act if they meet it
  static constexpr bool shield = true;           ///< by a third block
  static constexpr bool hands_over = true;       ///< springs (contact_handover)
  static constexpr bool keeps_decisions = true;  ///< while certain (contact_certainty)

  /// (19)
  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2);
  }
  /// At the height of the edge, between its ends, up to the slack.
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::between(c, p1, p2);
  }
  /// Not outside of one edge, up to the slack.
  static bool inside_edge(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::near_or_inside(c, p1, p2);
  }
  /// Not deeper than the centroid.
  static bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                           const Vec2& p2) {
    return geometry::within_depth(c, centroid, p1, p2);
  }
  /// inside_edge, between the edge's ends and within_depth.
  static bool in_reach_of_edge(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                               const Vec2& p2) {
    return geometry::in_reach_of_edge(c, centroid, p1, p2);
  }
  /// (20) for the corner's tangent towards `neighbour`.
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    return geometry::faces_edge(c, neighbour, p1, p2);
  }
  /// Sign of the difference of two overlaps.
  static int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                           const Vec2& q1, const Vec2& q2) {
    return geometry::compare_depth(c, p1, p2, q1, q2);
  }
};

/// Decides the groups of one list.
template <class Rules> class ContactDecision {
 public:
  ContactDecision(const Blocks& blocks, const Contacts& contacts,
                  const ContactGroups& groups)
      : blocks_(blocks), contacts_(contacts), place_(blocks), joint_(blocks, groups) {}

  // block: whose edges the group's are (ContactPair::edge_block)

  /// The record of the group that acts, or -1: the admissible edge with the least
  /// depth, if the corner is inside it (rule 12). Admissible: (20) holds for both
  /// tangents of the corner, the depth is at most that of the block's centroid (rule
  /// 9), and the corner is between the edge's ends (rule 10), which is asked of a
  /// convex block as a whole: the corner is inside all its edges, or outside of one
  /// that a side of its own block crosses (docs/departures.md). Where another edge of
  /// the block is nearer it has to meet the corner's block, which has else not come in
  /// through it; of several, one that meets it comes first. Blocks that are not convex:
  /// ReentrantBlock.
  ///
  /// What closed joints hide does not act (ClosedJoint): the next nearest edge acts in
  /// place of a hidden side, and in place of a flank that a hidden corner does not
  /// touch, unless that slopes as well.
  int acting_record(const ContactGroup& group, int block) const {
    const int c = contacts_.corner[group.first], out = place(c, block);
    const int nearest = nearest_record(group, block, out);
    if (nearest < 0 || !inside(nearest))
      return -1;
    if (Rules::shield && notch_record(group, block, nearest) < 0)
      return seen_record(group, block, out, nearest);
    return nearest;
  }

  /// Whether the condition of a certain group holds (Certainty).
  bool stands(const ContactGroup& group, int block) const {
    const int c = contacts_.corner[group.first];
    const int out = place_.outside_of(at(c), block);
    const int first = blocks_.first_corner[block];
    if ((out < 0 ? out : out - first) != group.place())
      return false;
    if (!group.asks || out == several)
      return true;
    if (out == none)
      return group.record() < 0 || comes_through(c, contacts_.edge[group.record()]);
    return !acts_beside_crossing(c, blocks_.previous[out], out) &&
           !acts_beside_crossing(c, blocks_.next[out], out);
  }

  /// Whether every corner is still on its side of the edge that is watched: then the
  /// condition holds.
  bool stays(const ContactGroup& group, int block) const {
    bool all = true;
    each_watched(group, block, [&](int c, int edge, int edge_end, bool outside) {
      all = all && Rules::inside_edge(at(c), at(edge), at(edge_end)) != outside;
    });
    return all;
  }
  /// Calls visit(corner, edge, its end, whether the corner is outside) for each of
  /// them.
  template <class Visit>
  void each_watched(const ContactGroup& group, int block, const Visit& visit) const {
    const Watch watch = group.watch();
    const int c = contacts_.corner[group.first], first = blocks_.first_corner[block];
    const int place = group.place(), out = first + place;
    for (const int edge : watch.edges)
      if (edge >= 0)
        visit(c, first + edge, blocks_.next[first + edge],
              place == edge || place == several);
    for (const bool after : {false, true})
      if (const unsigned number = watch.apart[after]; number > 0) {
        const auto [corner, edge, outside] =
            CrossingSides::beside(blocks_, c, out, after).apart(number);
        visit(corner, edge, blocks_.next[edge], outside);
      }
  }

  /// The record that acts as well, for the corner has to come out of a notch, or -1.
  int notch_record(const ContactGroup& group, int block, int acting) const {
    if (acting < 0 || !reentrant(block))
      return -1;
    const int c = contacts_.corner[group.first];
    const int other = ReentrantBlock<Rules>(blocks_, block)
                          .across_notch(at(c), contacts_.edge[acting]);
    if (other < 0 || Rules::overlap_sign(at(c), at(other), end(other)) <= 0)
      return -1;
    for (int i = group.first; i < group.last(); ++i)
      if (contacts_.edge[i] == other && admissible(c, other, block))
        return i;
    return -1;
  }

 private:
  using Place = PlaceInBlock<Rules>;
  static constexpr int none = Place::none, several = Place::several;

  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 end(int edge) const { return at(blocks_.next[edge]); }
  bool as_a_whole(int block) const {
    return Rules::whole_block && blocks_.convex[block];
  }
  bool reentrant(int block) const {
    return Rules::whole_block && !blocks_.convex[block];
  }

  /// (20) for both tangents.
  bool faces(int c, int edge) const {
    const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
    return Rules::faces_edge(corner, at(blocks_.previous[c]), p1, p2) &&
           Rules::faces_edge(corner, at(blocks_.next[c]), p1, p2);
  }
  /// Whether the block and the edge have a point in common. Two convex shapes are apart
  /// where the line of a side of either lies between them; an edge that has a point in
  /// another block has an end in it or crosses a side of it.
  bool meets(int edge, int block) const {
    return blocks_.convex[block] ? meets_convex<false>(edge, block)
                                 : meets_reentrant(edge, block);
  }
  /// The same up to the slack, of convex blocks: where bricks touch end to end,
  /// round-off does not decide.
  bool nearly_meets(int edge, int block) const {
    return blocks_.convex[block] ? meets_convex<true>(edge, block)
                                 : meets_reentrant(edge, block);
  }
  template <bool nearly> bool meets_convex(int edge, int block) const {
    const Vec2 p1 = at(edge), p2 = end(edge);
    const auto beyond = [](const Vec2& c, const Vec2& q1, const Vec2& q2) {
      return nearly ? !Rules::inside_edge(c, q1, q2)
                    : Rules::overlap_sign(c, q1, q2) < 0;
    };
    bool cut = false;
    for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1];
         ++q) {
      if (beyond(p1, at(q), end(q)) && beyond(p2, at(q), end(q)))
        return false;
      cut = cut || (nearly ? Rules::inside_edge(at(q), p2, p1) : beyond(at(q), p1, p2));
    }
    return cut;
  }
  bool meets_reentrant(int edge, int block) const {
    const Vec2 p1 = at(edge), p2 = end(edge);
    for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q)
      if (Rules::overlap_sign(p1, at(q), end(q)) *
                  Rules::overlap_sign(p2, at(q), end(q)) <=
              0 &&
          Rules::overlap_sign(at(q), p1, p2) * Rules::overlap_sign(end(q), p1, p2) <= 0)
        return true;
    return ReentrantBlock<Rules>(blocks_, block).contains(p1);
  }
  /// Whether another edge of the block is nearer to a corner inside.
  bool nearer_edge(int c, int edge) const {
    const int block = blocks_.corner_block[edge];
    for (int f = blocks_.first_corner[block]; f < blocks_.first_corner[block + 1]; ++f)
      if (f != edge && nearer(c, f, edge) &&
          (!reentrant(block) ||
           (Rules::inside_edge(at(c), at(f), end(f)) &&
            ReentrantBlock<Rules>(blocks_, block).spans(at(c), f))))
        return true;
    return false;
  }
  /// An edge that is not the nearest of all has to meet the corner's block, or, where
  /// that is wholly inside, to be the nearest for another of its corners. Asked of an
  /// edge that the corner is inside of: else nothing has come in.
  bool comes_through(int c, int edge) const {
    if (!Rules::far_edges_meet || !inside(c, edge))
      return true;
    const int own = blocks_.corner_block[c], block = blocks_.corner_block[edge];
    if (!nearer_edge(c, edge) || nearly_meets(edge, own))
      return true;
    for (int f = blocks_.first_corner[block]; f < blocks_.first_corner[block + 1]; ++f)
      if (nearly_meets(f, own))
        return false;
    for (int q = blocks_.first_corner[own]; q < blocks_.first_corner[own + 1]; ++q)
      if (!nearer_edge(q, edge))
        return true;
    return false;
  }
  /// Rules 9, 10 and (20) for one record; of a block taken as a whole, the corner is
  /// known to be inside.
  bool admissible(int c, int edge, int edge_block) const {
    const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
    const Vec2 centroid = blocks_.centroid.col(edge_block);
    if (reentrant(edge_block)) {
      const ReentrantBlock<Rules> block(blocks_, edge_block);
      return Rules::inside_edge(corner, p1, p2) && block.spans(corner, edge) &&
             block.within_depth(corner, edge) && faces(c, edge);
    }
    return (as_a_whole(edge_block)
                ? Rules::within_depth(corner, centroid, p1, p2)
                : Rules::in_reach_of_edge(corner, centroid, p1, p2)) &&
           faces(c, edge);
  }

  /// Whether an edge acts on a corner that is outside of the block, but only for a side
  /// `out` beside that edge, which a side of the corner's block crosses.
  bool acts_beside_crossing(int c, int edge, int out) const {
    if (out != blocks_.next[edge] && out != blocks_.previous[edge])
      return false;
    const bool after = out == blocks_.next[edge];
    const int block = blocks_.corner_block[edge];
    const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
    if (!Rules::between(corner, p1, p2) || !faces(c, edge))
      return false;
    const CrossingSides sides(blocks_, c, edge, after);
    if (reentrant(block)) {  // where all other edges have not been asked
      const ReentrantBlock<Rules> whole(blocks_, block);
      if (whole.turns_inwards(after ? out : edge) ||
          Rules::inside_edge(corner, at(out), end(out)) ||
          !Rules::inside_edge(corner, p1, p2) || !whole.within_depth(corner, edge) ||
          !far_ends_are_inside<Rules>(blocks_, sides))
        return false;
    } else if (!Rules::within_depth(corner, blocks_.centroid.col(block), p1, p2)) {
      return false;
    }
    return sides_cross<Rules>(blocks_, sides, c, edge);
  }

  /// Whether the edge may act on a corner that outside_of has found here.
  bool may_act(int c, int edge, int block, int out) const {
    if (out == none)
      return admissible(c, edge, block);
    if (out != several)
      return acts_beside_crossing(c, edge, out);
    return acts_beside_crossing(c, edge, blocks_.previous[edge]) ||
           acts_beside_crossing(c, edge, blocks_.next[edge]);
  }

  /// The record that acts where closed joints hide the nearest edge, or the corner: the
  /// nearest, the next, or -1.
  int seen_record(const ContactGroup& group, int block, int out, int nearest) const {
    const int c = contacts_.corner[nearest], edge = contacts_.edge[nearest];
    const int i = next_record(group, block, out, nearest);
    const int next = i < 0 ? -1 : contacts_.edge[i];
    if (next >= 0 && joint_.hides_side(c, edge, next))
      return i;
    if (!joint_.hides_corner(c, edge))
      return nearest;
    return next >= 0 && joint_.shallow(c, next) && !joint_.hides_corner(c, next) ? i
                                                                                 : -1;
  }

  bool nearer(int c, int edge, int other) const {
    return Rules::compare_depth(at(c), at(edge), end(edge), at(other), end(other)) < 0;
  }

  /// outside_of for the blocks that are taken as a whole.
  int place(int c, int block) const {
    if (as_a_whole(block))
      return place_.outside_of(at(c), block);
    const bool outside =
        reentrant(block) && !ReentrantBlock<Rules>(blocks_, block).holds(at(c));
    return outside ? several : none;
  }

  /// In a notch a corner is as deep as below the deeper of both edges.
  int depth_edge(int c, int edge) const {
    const int block = blocks_.corner_block[edge];
    if (!reentrant(block))
      return edge;
    const int other = ReentrantBlock<Rules>(blocks_, block).across_notch(at(c), edge);
    return other >= 0 && nearer(c, edge, other) ? other : edge;
  }
  /// The depth below record i is less than below the other, if there is one.
  bool precedes(int i, int other) const {
    const int c = contacts_.corner[i];
    return other < 0 || nearer(c, depth_edge(c, contacts_.edge[i]),
                               depth_edge(c, contacts_.edge[other]));
  }

  /// The record with the least depth that may act, -1: none. out: place. Inside
  /// of several, one whose edge meets the corner's block comes first.
  int nearest_record(const ContactGroup& group, int block, int out) const {
    const int c = contacts_.corner[group.first];
    int found = -1, others = -1;
    if (out == several && !reentrant(block))
      return found;
    const auto may = [&](int i) {
      return may_act(c, contacts_.edge[i], block, out) &&
             (out != none || comes_through(c, contacts_.edge[i]));
    };
    for (int i = group.first; i < group.last(); ++i)
      if (may(i)) {
        ++others;
        if (precedes(i, found))
          found = i;
      }
    if (!Rules::far_edges_meet || out != none || others < 1 || !inside(found) ||
        has_met(c, found))
      return found;
    int met = -1;
    for (int i = group.first; i < group.last(); ++i)
      if (i != found && may(i) && precedes(i, met) && has_met(c, i))
        met = i;
    return met < 0 ? found : met;
  }
  /// A > 0 for the record.
  bool inside(int i) const { return inside(contacts_.corner[i], contacts_.edge[i]); }
  bool inside(int c, int edge) const {
    return Rules::overlap_sign(at(c), at(edge), end(edge)) > 0;
  }
  bool has_met(int c, int i) const {
    return meets(contacts_.edge[i], blocks_.corner_block[c]);
  }

  /// Of the other records that may act, met or not, that with the least depth, -1:
  /// none.
  int next_record(const ContactGroup& group, int block, int out, int nearest) const {
    const int c = contacts_.corner[group.first];
    int found = -1;
    for (int i = group.first; i < group.last(); ++i)
      if (i != nearest && may_act(c, contacts_.edge[i], block, out) &&
          precedes(i, found))
        found = i;
    return found;
  }

  const Blocks& blocks_;
  const Contacts& contacts_;
  const PlaceInBlock<Rules> place_;
  const ClosedJoint<Rules> joint_;
};

/// ContactDecision<ExactRules>::acting_record, compiled once.
int acting_record(const Blocks& blocks, const Contacts& contacts,
                  const ContactGroups& groups, const ContactGroup& group, int block);

}  // namespace blocks::dynamics
