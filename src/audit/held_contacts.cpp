#include "audit/held_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/contact_constants.hpp"

namespace blocks::audit {

std::vector<HeldContact> held_contacts(const Model& model) {
  std::vector<HeldContact> held;
  for (std::size_t i = 0; i < model.law_states.size(); ++i) {
    const LawState& state = model.law_states[i];
    if (state.bonded || state.offset > 0.0)
      held.push_back({model.contacts[i].corner, model.contacts[i].edge, state.bonded,
                      state.offset, state.failed});
  }
  return held;
}

HeldContacts::HeldContacts(const Moment& moment) : blocks_(moment.blocks) {
  for (const HeldContact& one : moment.held) {
    const CornerEdge key(one.corner, one.edge);
    held_.emplace(key, one);
    const int a = blocks_.corner_block[one.corner], b = blocks_.corner_block[one.edge];
    of_pair_[std::minmax(a, b)].push_back(key);
  }
}

int is_on_edge(const Blocks& blocks, const CornerEdge& contact, double overlap) {
  // A fraction of the length of the edge: much more than the rounding of the step, much
  // less than any dilation that matters.
  constexpr double tolerance = 1e-9;
  const auto [corner, edge] = contact;
  const Vec2 start = blocks.corner.col(edge),
             side = blocks.corner.col(blocks.next[edge]) - start;
  const double length = side.norm();
  const double part =
      (Vec2(blocks.corner.col(corner)) - start).dot(side) / (length * length);
  const double depth = overlap / length;
  const double between = std::min(part, 1.0 - part) + geometry::contact_slack;
  const double min = std::min(depth, between);
  return std::abs(min) <= tolerance ? -1 : min > 0.0 ? 1 : 0;
}

int HeldContacts::holds_open(const CornerEdge& contact, double offset,
                             const ExactPairRule& rule) const {
  return is_on_edge(blocks_, contact,
                    rule.overlap(contact.first, contact.second) + offset);
}

std::array<CornerEdge, 2> HeldContacts::at_same_end(const CornerEdge& contact) const {
  const auto [corner, edge] = contact;
  return {CornerEdge(edge, blocks_.previous[corner]),
          CornerEdge(blocks_.next[edge], corner)};
}

std::vector<CornerEdge> HeldContacts::expected(const BlockPair& pair,
                                               const std::vector<CornerEdge>& by_rule,
                                               const std::vector<CornerEdge>& acting,
                                               const ExactPairRule& rule) const {
  const auto found = of_pair_.find(pair);
  if (found == of_pair_.end())
    return by_rule;
  std::set<int> bonded;  // corners of these two blocks
  std::set<CornerEdge> all;
  for (const CornerEdge& key : found->second)
    if (held_.at(key).bonded) {
      bonded.insert(key.first);
      // A weakened contact ends where its corner leaves the edge.
      const int open = held_.at(key).failed ? holds_open(key, HUGE_VAL, rule) : 1;
      if (open > 0 ||
          (open < 0 && std::binary_search(acting.begin(), acting.end(), key)))
        all.insert(key);
    }
  for (const CornerEdge& key : by_rule)
    if (!bonded.contains(key.first))
      all.insert(key);
  for (const CornerEdge& key : found->second) {
    if (held_.at(key).bonded || bonded.contains(key.first) || all.contains(key))
      continue;
    const int open = holds_open(key, held_.at(key).offset, rule);
    const bool acts = std::binary_search(acting.begin(), acting.end(), key);
    if (open > 0 || (open < 0 && acts))
      all.insert(key);
    if (open <= 0)
      for (const CornerEdge& beside : at_same_end(key))
        if (std::binary_search(acting.begin(), acting.end(), beside))
          all.insert(beside);
  }
  return {all.begin(), all.end()};
}

}  // namespace blocks::audit
