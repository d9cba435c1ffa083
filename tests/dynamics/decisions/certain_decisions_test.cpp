// Certain decisions agree with the exact rule, at once and after any motion within
// their validity distance.
#include "dynamics/decisions/certain_decisions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "audit/clusters.hpp"
#include "dynamics/decisions/contact_rule.hpp"
#include "dynamics/step.hpp"
#include "dynamics/update_pairs.hpp"
#include "study/scene_builder.hpp"

namespace blocks::dynamics {
namespace {

using Contacts = std::vector<CornerOnEdge>;

void sort(Contacts& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const CornerOnEdge& l, const CornerOnEdge& r) {
              return std::pair(l.corner, l.edge) < std::pair(r.corner, r.edge);
            });
}

/// A random cluster of blocks with its near pairs and their certain decisions.
struct Cluster {
  explicit Cluster(std::uint64_t number)
      : model(study::scenes::SceneBuilder("cluster", "", 0).model()), clusters(number) {
    model.settings.lower = {-200, -200}, model.settings.upper = {200, 200};
    model.blocks.append(
        clusters.make(static_cast<int>(number % testing::Clusters::kinds)));
    if (model.blocks.size() < 2)
      return;
    prepare(model);
    update_pairs(model, work);
    std::vector<int> due(work.index.pairs.size());
    std::iota(due.begin(), due.end(), 0);
    certain.find(model.blocks, work.parts, work.index, work.decisions, due);
  }

  /// Returns the contacts of the exact rule.
  Contacts exact(int p) {
    exact_rule().decide(model.blocks, work.parts, work.index, p, scratch);
    Contacts found = scratch.found;
    sort(found);
    return found;
  }
  /// Returns the contacts of a certain decision that act at the present positions.
  Contacts acting(int p) const {
    Contacts found;
    const auto at = [&](int c) { return Vec2(model.blocks.corner.col(c)); };
    for (const CornerOnEdge& contact : certain[static_cast<std::size_t>(p)].contacts) {
      const Vec2 c = at(contact.corner), p1 = at(contact.edge),
                 p2 = at(model.blocks.next[contact.edge]);
      if (geometry::overlap_sign(c, p1, p2) > 0 && geometry::between(c, p1, p2))
        found.push_back(contact);
    }
    sort(found);
    return found;
  }
  /// Moves a block rigidly. The shift of its centroid plus twice the motion of its
  /// longest arm is `length`.
  void move(int b, double length) {
    Blocks& blocks = model.blocks;
    const double share = clusters.uniform(0.0, 1.0);
    const double angle = clusters.uniform(0.0, 6.283);
    const double turn = (clusters.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * share *
                        length / (2.0 * work.decisions.bounds.longest[b]);
    const Vec2 shift = (1.0 - share) * length * Vec2(std::cos(angle), std::sin(angle));
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
    blocks.gradient.col(b) << rotation(0, 0), rotation(0, 1), rotation(1, 0),
        rotation(1, 1);
    blocks.centroid.col(b) += shift;
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      blocks.corner.col(c) =
          blocks.centroid.col(b) + rotation * Vec2(blocks.arm.col(c));
  }

  Model model;
  testing::Clusters clusters;
  Workspace work;
  CertainDecisions certain;
  PairScratch scratch;
};

struct Count {
  long pairs = 0, certain = 0, acting = 0, moved = 0, changed = 0;
};

TEST(CertainDecisions, AgreeWithTheExactRuleAfterMotionWithinTheirRoom) {
  const std::uint64_t clusters =
      std::getenv("BLOCKS_THOROUGH") != nullptr ? 1'000'000 : 30'000;
  Count count;
  for (std::uint64_t number = 0; number < clusters; ++number) {
    SCOPED_TRACE(number);
    Cluster cluster(number);
    const PairIndex& index = cluster.work.index;
    for (int p = 0; p < static_cast<int>(index.pairs.size()); ++p) {
      ++count.pairs;
      const CertainDecision& decision = cluster.certain[static_cast<std::size_t>(p)];
      if (!(decision.validity > 0.0))
        continue;
      ++count.certain;
      const Contacts before = cluster.exact(p);
      ASSERT_EQ(cluster.acting(p), before) << "pair " << p;
      count.acting += !before.empty();
      const Blocks start = cluster.model.blocks;
      Blocks& blocks = cluster.model.blocks;
      Decisions& decisions = cluster.work.decisions;
      const NearPair& pair = index.pairs[p];
      decisions.keep_certain(blocks, pair, p, decision.validity, decision.growth);
      const double longest = decisions.bounds.longest_path;
      for (int trial = 0; trial < 2; ++trial) {
        const double own = cluster.clusters.uniform(0.0, 0.999) * decision.validity;
        const double share = cluster.clusters.uniform(0.0, 1.0);
        // All blocks move by less than the growth, or the two alone move by more.
        const double growth = std::min(1.0, 0.999 * decision.growth);
        const double common = trial == 0 ? std::min(own, growth) : own;
        cluster.move(pair.low, share * common);
        cluster.move(pair.high, (1.0 - share) * common);
        for (int b = 0; b < start.size(); ++b)
          if (b != pair.low && b != pair.high)
            cluster.move(b, cluster.clusters.uniform(0.0, 1.0) * growth);
        decisions.bounds.longest_path = longest + std::max(growth, common);
        decisions.pairs[p].examined_at_pair_path = 0.0;
        decisions.pairs[p].examined_at_longest_path = 0.0;
        if (decisions.holds(blocks, cluster.work.parts, pair, p)) {
          const Contacts after = cluster.exact(p);
          ASSERT_EQ(cluster.acting(p), after) << "pair " << p << " moved by " << own;
          ++count.moved;
          count.changed += before != after;
        }
        blocks = start;
      }
      decisions.bounds.longest_path = longest;
    }
  }
  EXPECT_GT(count.certain, count.pairs / 2) << "of " << count.pairs;
  EXPECT_GT(count.acting, count.certain / 4);
  EXPECT_GT(count.moved, count.certain);
  EXPECT_GT(count.changed, count.moved / 100);
  RecordProperty("pairs", static_cast<int>(count.pairs));
  RecordProperty("in_doubt", static_cast<int>(count.pairs - count.certain));
}

// A depth does not leave its limits while the motion of the pair is shorter than the
// bound. So no step needs to compute it before.
TEST(KeptDepths, StayInTheirLimitsDuringShortMotion) {
  long counted = 0;
  for (std::uint64_t number = 0; number < 10'000; ++number) {
    SCOPED_TRACE(number);
    Cluster cluster(number);
    const Decisions& decisions = cluster.work.decisions;
    Blocks& blocks = cluster.model.blocks;
    for (int p = 0; p < cluster.work.index.size(); ++p) {
      cluster.exact(p);
      const double motion = decisions.motion_to_limits(blocks, cluster.work.parts,
                                                       cluster.scratch.depths);
      if (!(motion > 1e-9 && motion < 1.0))
        continue;
      const Blocks start = blocks;
      const auto [low, high] = cluster.work.index.pairs[p];
      const double share = cluster.clusters.uniform(0.0, 1.0);
      cluster.move(low, share * 0.999 * motion);
      cluster.move(high, (1.0 - share) * 0.999 * motion);
      ASSERT_GT(decisions.motion_to_limits(blocks, cluster.work.parts,
                                           cluster.scratch.depths),
                0.0)
          << "pair " << p << " moved by " << motion;
      ++counted;
      blocks = start;
    }
  }
  EXPECT_GT(counted, 10'000);
}

}  // namespace
}  // namespace blocks::dynamics
