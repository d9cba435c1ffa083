// What is certain of a pair of blocks against the exact rule, at once and after motion
// within the room.
#include "dynamics/certain_decisions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "audit/clusters.hpp"
#include "dynamics/pair_decisions.hpp"
#include "dynamics/pair_step.hpp"
#include "study/draft.hpp"

namespace blocks::dynamics {
namespace {

using Contacts = std::vector<CornerOnEdge>;

void sort(Contacts& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const CornerOnEdge& l, const CornerOnEdge& r) {
              return std::pair(l.corner, l.edge) < std::pair(r.corner, r.edge);
            });
}

/// A cluster with its pairs.
struct Cluster {
  explicit Cluster(std::uint64_t number)
      : model(study::scenes::Draft("cluster", "", 0).model()), clusters(number) {
    model.settings.lower = {-200, -200}, model.settings.upper = {200, 200};
    model.blocks.append(
        clusters.make(static_cast<int>(number % testing::Clusters::kinds)));
    if (model.blocks.size() < 2)
      return;
    prepare(model);
    update_pairs(model, buffers);
    std::vector<int> due(buffers.pairs.pairs.size());
    std::iota(due.begin(), due.end(), 0);
    certain.find(model.blocks, buffers.pairs, due, model.time_step.dt);
  }

  Contacts exact(int p) {
    decide_exactly<ExactPredicates>(model.blocks, buffers.pairs, p, scratch);
    Contacts found = scratch.found;
    sort(found);
    return found;
  }
  /// The contacts of a certain decision that act where the blocks are now.
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
  /// Moves a block rigidly by a way of this length (Swing).
  void move(int b, double way) {
    Blocks& blocks = model.blocks;
    const double share = clusters.uniform(0.0, 1.0);
    const double angle = clusters.uniform(0.0, 6.283);
    const double turn = (clusters.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * share * way /
                        (2.0 * buffers.pairs.swing.longest[b]);
    const Vec2 shift = (1.0 - share) * way * Vec2(std::cos(angle), std::sin(angle));
    const Eigen::Rotation2D<double> rotation(turn);
    const Vec2 centroid = blocks.centroid.col(b);
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      blocks.corner.col(c) =
          centroid + shift + rotation * (blocks.corner.col(c) - centroid);
    blocks.centroid.col(b) = centroid + shift;
  }

  Model model;
  testing::Clusters clusters;
  SearchBuffers buffers;
  CertainDecisions certain;
  PairScratch scratch;
};

struct Count {
  long pairs = 0, certain = 0, acting = 0, moved = 0, changed = 0;
};

TEST(CertainDecisions, AreThoseOfTheExactRuleWhileTheirRoomLasts) {
  const std::uint64_t clusters =
      std::getenv("BLOCKS_THOROUGH") != nullptr ? 1'000'000 : 30'000;
  Count count;
  for (std::uint64_t number = 0; number < clusters; ++number) {
    SCOPED_TRACE(number);
    Cluster cluster(number);
    const PairContacts& all = cluster.buffers.pairs;
    for (int p = 0; p < static_cast<int>(all.pairs.size()); ++p) {
      ++count.pairs;
      const CertainDecision& decision = cluster.certain[static_cast<std::size_t>(p)];
      if (!(decision.room > 0.0))
        continue;
      ++count.certain;
      const Contacts before = cluster.exact(p);
      ASSERT_EQ(cluster.acting(p), before) << "pair " << p;
      count.acting += !before.empty();
      const Blocks start = cluster.model.blocks;
      for (int trial = 0; trial < 2; ++trial) {
        // the blocks of the pair together by less than the room, and others by less
        // than theirs, in all
        const double own = cluster.clusters.uniform(0.0, 0.999) * decision.room;
        const double share = cluster.clusters.uniform(0.0, 1.0);
        const NearPair& pair = all.pairs[p];
        cluster.move(pair.low, share * own);
        cluster.move(pair.high, (1.0 - share) * own);
        // the ways of the two count twice among those of the neighbours
        const double left = std::min(1.0, decision.room_of_neighbours) - 2.0 * own;
        for (int b = 0; b < start.size(); ++b)
          if (b != pair.low && b != pair.high && left > 0.0)
            cluster.move(b, left / (2.0 * start.size()));
        const Contacts after = cluster.exact(p);
        if (left > 0.0) {
          ASSERT_EQ(cluster.acting(p), after) << "pair " << p << " moved by " << own;
          ++count.moved;
          count.changed += before != after;
        }
        cluster.model.blocks = start;
      }
    }
  }
  EXPECT_GT(count.certain, count.pairs / 2) << "of " << count.pairs;
  EXPECT_GT(count.acting, count.certain / 4);
  EXPECT_GT(count.moved, count.certain);
  EXPECT_GT(count.changed, count.moved / 100);
  RecordProperty("pairs", static_cast<int>(count.pairs));
  RecordProperty("in_doubt", static_cast<int>(count.pairs - count.certain));
}

}  // namespace
}  // namespace blocks::dynamics
