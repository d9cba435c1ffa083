#include "audit/audit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "audit/common_depth.hpp"
#include "audit/held_contacts.hpp"
#include "audit/kept_pairs.hpp"
#include "audit/make_exact_rule.hpp"
#include "audit/plane_findings.hpp"
#include "audit/water_findings.hpp"
#include "geometry/overlap.hpp"
#include "model/compression.hpp"

namespace blocks::audit {
namespace {

/// Returns the depth of the deepest axis that does not act because a third part hides
/// it or because its side is an inner side, [L]. Returns 0 if there is none.
double depth_explained_by_third_parts(const PairDecision& decision) {
  double depth = 0.0;
  for (const PartDecision& parts : decision.parts)
    for (const Axis& axis : parts.axes)
      if (axis.examined && (axis.side.inner || axis.hidden()))
        depth = std::max(depth, axis.depth);
  return depth;
}

class Auditor {
 public:
  explicit Auditor(const Moment& moment)
      : blocks_(moment.blocks), contacts_(moment.contacts), settings_(moment.settings),
        states_(moment.law_states), listed_(moment.listed), held_(moment),
        kept_(moment),
        // Each of the two blocks of a pair may move by moment.left.
        rule_(make_exact_rule(moment.blocks, 2.0 * moment.left, moment.order)) {}

  Findings run() {
    look_for_faults();
    overlaps_ = overlaps();
    look_for_excess();
    look_for_deep();
    return std::move(found_);
  }

 private:
  /// Finds missed pairs and wrong decisions.
  void look_for_faults() {
    std::map<BlockPair, std::vector<std::pair<int, int>>> acting;
    found_.acting = static_cast<long>(contacts_.size());
    for (const Contact& contact : contacts_)
      acting[pair_of(blocks_, contact)].emplace_back(contact.corner, contact.edge);
    for (const BlockPair& pair : held_.pairs())  // they may be apart
      acting[pair];
    for (int a = 0; a < blocks_.size(); ++a)
      for (const int b : rule_.neighbours(a)) {
        if (b < a)
          continue;
        ++found_.pairs;
        if (!std::binary_search(listed_.begin(), listed_.end(), BlockPair(a, b)))
          found_.missed.emplace_back(a, b);
        const PairDecision exact = rule_.decide(a, b);
        by_third_[{a, b}] = depth_explained_by_third_parts(exact);
        auto by_program = std::move(acting[{a, b}]);
        acting.erase({a, b});
        compare({a, b}, std::move(by_program), exact.contacts);
      }
    for (auto& [pair, contacts] : acting)  // the two blocks are not near each other
      if (blocks_.may_touch(pair.first, pair.second))
        compare(pair, std::move(contacts), {});
  }

  /// Records a wrong decision unless the contacts of a pair are those of the rule, now
  /// or where the pair was decided, and of the laws of joints.
  void compare(const BlockPair& pair, std::vector<std::pair<int, int>> by_program,
               const std::vector<std::pair<int, int>>& by_rule) {
    std::sort(by_program.begin(), by_program.end());
    std::vector<std::pair<int, int>> exact =
        held_.expected(pair, by_rule, by_program, rule_);
    if (by_program == exact)
      return;
    if (const auto by_kept = kept_.contacts(pair, by_program, rule_);
        by_kept && by_program == held_.expected(pair, *by_kept, by_program, rule_)) {
      ++found_.late;
      return;
    }
    found_.wrong.push_back(
        {pair.first, pair.second, std::move(by_program), std::move(exact)});
  }

  double shortest_edge(int block) const {
    double shortest = INFINITY;
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
      shortest = std::min(
          shortest,
          Vec2(blocks_.corner.col(blocks_.next[e]) - blocks_.corner.col(e)).norm());
    return shortest;
  }

  /// Returns the tolerance of depths of two blocks and of their contacts, [L].
  double slack(int a, int b) const {
    return explained_slack * std::min(shortest_edge(a), shortest_edge(b));
  }

  std::vector<geometry::BlockOverlap> overlaps() const {
    return geometry::overlapping_pairs(blocks_.present_outlines(), {},
                                       geometry::Figures::quick);
  }

  /// Returns how far a contact is pressed in, [L]: the compression of its spring, or
  /// what its force would need.
  double pressed(std::size_t i) const {
    const double needed = i < states_.size() && states_[i].stiffness > 0.0
                              ? contacts_[i].normal_elastic / states_[i].stiffness
                              : 0.0;
    return std::max(compression(settings_, contacts_, states_, i), needed);
  }

  void look_for_excess() {
    struct Held {
      double depth = 0.0, pressed = 0.0;
    };
    std::map<BlockPair, Held> held;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Contact& contact = contacts_[i];
      Held& pair = held[pair_of(blocks_, contact)];
      pair.depth = std::max(pair.depth, rule_.overlap(contact.corner, contact.edge));
      pair.pressed = std::max(pair.pressed, pressed(i));
    }
    for (const auto& overlap : overlaps_) {
      const int a = overlap.first, b = overlap.second;
      if (!blocks_.may_touch(a, b))
        continue;
      const Held& contact_held = held[{a, b}];
      const ExcessOverlap excess{a,
                                 b,
                                 overlap.depth,
                                 std::max(contact_held.depth, by_third_[{a, b}]),
                                 contact_held.pressed,
                                 overlap.area,
                                 overlap.place};
      if (excess.excess() > found_.worst.excess())
        found_.worst = excess;
      if (excess.excess() > slack(a, b))
        found_.excess.push_back(excess);
    }
    std::sort(found_.excess.begin(), found_.excess.end(),
              [](const auto& a, const auto& b) { return a.excess() > b.excess(); });
  }

  void look_for_deep() {
    std::set<BlockPair> overlapping;
    for (const auto& overlap : overlaps_)
      overlapping.insert({overlap.first, overlap.second});
    const CommonDepth common(blocks_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Contact& contact = contacts_[i];
      const int c = contact.corner, e = contact.edge;
      if (held_.contains(c, e))
        continue;  // it may act beyond the overlap of the blocks
      const int a = blocks_.corner_block[c], b = blocks_.corner_block[e];
      const double deep = rule_.overlap(c, e), tolerance = slack(a, b);
      if (deep <= tolerance)
        continue;
      const bool meet = overlapping.contains(pair_of(blocks_, contact));
      const DeepContact found{c, e, deep, meet ? common.along_normal(e, a) : 0.0,
                              pressed(i)};
      if (found.excess() > found_.deepest.excess())
        found_.deepest = found;
      if (found.excess() > tolerance)
        found_.deep.push_back(found);
    }
    std::sort(found_.deep.begin(), found_.deep.end(),
              [](const auto& a, const auto& b) { return a.excess() > b.excess(); });
  }

  const Blocks& blocks_;
  const std::vector<Contact>& contacts_;
  const Settings& settings_;
  const std::vector<LawState>& states_;
  const std::vector<BlockPair>& listed_;
  const HeldContacts held_;
  const KeptPairs kept_;
  ExactPairRule rule_;
  /// [L] depth_explained_by_third_parts of each pair
  std::map<BlockPair, double> by_third_;
  std::vector<geometry::BlockOverlap> overlaps_;
  Findings found_;
};

}  // namespace

Findings audit(const Moment& moment) {
  Findings found = Auditor(moment).run();
  found.wrong_at_planes = plane_faults(moment);
  found.behind = deepest_behind_plane(moment);
  found.water = worst_water(moment);
  return found;
}

}  // namespace blocks::audit
