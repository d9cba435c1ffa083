#include "audit/audit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "audit/common_depth.hpp"
#include "geometry/overlap.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::audit {
namespace {

using Pair = std::pair<int, int>;

class Auditor {
 public:
  explicit Auditor(const Moment& moment)
      : blocks_(moment.blocks), contacts_(moment.contacts), settings_(moment.settings),
        promise_(2.0 * moment.left), rules_(blocks_, promise_) {
    for (int i = 0; i < contacts_.size(); ++i) {
      listed_.insert({contacts_.corner[i], contacts_.edge[i]});
      if (contacts_.active[i])
        acting_[{contacts_.corner[i], blocks_.corner_block[contacts_.edge[i]]}]
            .push_back(contacts_.edge[i]);
    }
  }

  Findings run() {
    for (int c = 0; c < blocks_.corners(); ++c)
      for (const int b : rules_.near(c)) {
        ++found_.pairs;
        const Decision decision = rules_.decide(c, b);
        look_for_missed(decision);
        compare(decision);
      }
    for (const auto& [pair, edges] : acting_)  // nowhere near: none may act
      for (const int edge : edges)
        if (!fixed(pair.first, pair.second))
          found_.wrong.push_back({pair.first, pair.second, edge, -1});
    overlaps_ = overlaps();
    look_for_excess();
    look_for_deep();
    return std::move(found_);
  }

 private:
  bool fixed(int corner, int block) const {
    return !blocks_.is_free(blocks_.corner_block[corner]) && !blocks_.is_free(block);
  }

  void look_for_missed(const Decision& decision) {
    const int c = decision.corner, b = decision.block;
    for (int e = blocks_.first_corner[b]; e < blocks_.first_corner[b + 1]; ++e) {
      if (!within_promise(c, e) && !decision.acts(e) &&
          !(decision.inside && rules_.admits(c, e)))
        continue;
      ++found_.records;
      if (!listed_.contains({c, e}))
        found_.missed.push_back({c, e, rules_.overlap(c, e), decision.allows(e)});
    }
  }

  /// The corner is this close to the edge's segment; rounded, so a little less.
  bool within_promise(int corner, int edge) const {
    const Vec2 p = blocks_.corner.col(edge);
    const Vec2 e = Vec2(blocks_.corner.col(blocks_.next[edge])) - p;
    const Vec2 from = Vec2(blocks_.corner.col(corner)) - p;
    const double s = std::clamp(from.dot(e) / e.squaredNorm(), 0.0, 1.0);
    return (from - s * e).norm() <= promise_ * (1.0 - 1e-9);
  }

  void compare(const Decision& decision) {
    found_.hanging += decision.possible.size() > 1;
    if (decision.hidden.answer != Answer::no) {
      double& depth =
          by_joint_[std::minmax(blocks_.corner_block[decision.corner], decision.block)];
      depth = std::max(depth, decision.hidden.depth);
    }
    const auto at = acting_.find({decision.corner, decision.block});
    std::vector<int> edges;
    if (at != acting_.end()) {
      edges = at->second;
      acting_.erase(at);
    }
    found_.acting += static_cast<long>(edges.size());
    if (edges.empty() && !decision.allows(-1))
      found_.wrong.push_back({decision.corner, decision.block, -1, decision.acting});
    if (edges.size() == 1 && decision.notch >= 0)
      found_.wrong.push_back({decision.corner, decision.block, -1, decision.notch});
    // one edge of a block acts on a corner at most, or two of a notch
    const std::size_t most = decision.notch < 0 ? 1 : 2;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (i >= most || !decision.allows(edges[i]))
        found_.wrong.push_back(
            {decision.corner, decision.block, edges[i], decision.acting});
  }

  double shortest_edge(int block) const {
    double shortest = INFINITY;
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
      shortest = std::min(
          shortest,
          Vec2(blocks_.corner.col(blocks_.next[e]) - blocks_.corner.col(e)).norm());
    return shortest;
  }

  /// [L] What depths of two blocks and of their contacts may differ by.
  double slack(int a, int b) const {
    return explained_slack * std::min(shortest_edge(a), shortest_edge(b));
  }

  std::vector<geometry::BlockOverlap> overlaps() const {
    std::vector<geometry::Polygon> outlines;
    for (int b = 0; b < blocks_.size(); ++b)
      outlines.push_back(blocks_.outline(b));
    return geometry::overlapping_pairs(outlines, {}, geometry::Figures::quick);
  }

  void look_for_excess() {
    struct Held {
      double depth = 0.0, pressed = 0.0;
    };
    std::map<Pair, Held> held;
    for (int i = 0; i < contacts_.size(); ++i) {
      if (!contacts_.active[i])
        continue;
      Held& pair = held[pair_of(blocks_, contacts_, i)];
      pair.depth =
          std::max(pair.depth, rules_.overlap(contacts_.corner[i], contacts_.edge[i]));
      pair.pressed = std::max(pair.pressed, contacts_.at(i).normal_elastic /
                                                settings_.normal_stiffness);
    }
    for (const auto& overlap : overlaps_) {
      const int a = overlap.first, b = overlap.second;
      if (!blocks_.is_free(a) && !blocks_.is_free(b))
        continue;
      const Held& by = held[{a, b}];
      const ExcessOverlap excess{a,
                                 b,
                                 overlap.depth,
                                 std::max(by.depth, by_joint_[{a, b}]),
                                 by.pressed,
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
    std::set<Pair> overlapping;
    for (const auto& overlap : overlaps_)
      overlapping.insert({overlap.first, overlap.second});
    const CommonDepth common(blocks_);
    for (int i = 0; i < contacts_.size(); ++i) {
      if (!contacts_.active[i])
        continue;
      const int c = contacts_.corner[i], e = contacts_.edge[i];
      const int a = blocks_.corner_block[c], b = blocks_.corner_block[e];
      const double deep = rules_.overlap(c, e), tolerance = slack(a, b);
      if (deep <= tolerance)
        continue;
      const bool meet = overlapping.contains(pair_of(blocks_, contacts_, i));
      const DeepContact contact{c, e, deep, meet ? common.along_normal(e, a) : 0.0,
                                contacts_.at(i).normal_elastic /
                                    settings_.normal_stiffness};
      if (contact.excess() > found_.deepest.excess())
        found_.deepest = contact;
      if (contact.excess() > tolerance)
        found_.deep.push_back(contact);
    }
    std::sort(found_.deep.begin(), found_.deep.end(),
              [](const auto& a, const auto& b) { return a.excess() > b.excess(); });
  }

  const Blocks& blocks_;
  const Contacts& contacts_;
  const Settings& settings_;
  double promise_;
  ExactRules rules_;
  std::set<Pair> listed_;                    ///< corner, edge
  std::map<Pair, double> by_joint_;          ///< blocks: how deep a toe is in a joint
  std::map<Pair, std::vector<int>> acting_;  ///< corner, block: edges not seen yet
  std::vector<geometry::BlockOverlap> overlaps_;
  Findings found_;
};

}  // namespace

Findings audit(const Moment& moment) { return Auditor(moment).run(); }

}  // namespace blocks::audit
