// Decisions that outlive a search, or cracks.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "dynamics/decisions/decisions.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

PairIndex index_of(std::vector<NearPair> pairs, int blocks) {
  PairIndex index;
  index.take(pairs, blocks);
  return index;
}

/// Decisions of all pairs, which depend on neighbours if the second limit is finite.
Decisions made(const PairIndex& index, double of_neighbours) {
  Decisions decisions;
  for (int p = 0; p < index.size(); ++p) {
    decisions.limits.push_back({1.0 + p, of_neighbours});
    decisions.next_check.push_back(0.25 + p);
  }
  return decisions;
}

std::vector<double> limits_of(const Decisions& decisions) {
  std::vector<double> limits;
  for (const PairMotion& limit : decisions.limits)
    limits.push_back(limit.two);
  return limits;
}

// A row of six blocks. A search finds that blocks 0 and 2 are near, and no longer lists
// blocks 4 and 5.
const std::vector<NearPair> row = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}};
const std::vector<NearPair> later = {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}};

TEST(KeptDecisions, OutliveASearch) {
  const PairIndex old = index_of(row, 6), now = index_of(later, 6);
  Decisions decisions = made(old, infinite);
  decisions.keep_in(now, old, {});
  EXPECT_EQ(limits_of(decisions), (std::vector<double>{1, 0, 2, 3, 4}));
  EXPECT_EQ(decisions.next_check, (std::vector<double>{0.25, 0, 1.25, 2.25, 3.25}));
}

TEST(KeptDecisions, EndIfANewNeighbourMayMatter) {
  const PairIndex old = index_of(row, 6), now = index_of(later, 6);
  Decisions decisions = made(old, 10.0);
  decisions.keep_in(now, old, {});
  // Blocks 0 and 2 have a new neighbour. Blocks 3 and 4 have lost one at most.
  EXPECT_EQ(limits_of(decisions), (std::vector<double>{0, 0, 0, 0, 4}));
}

TEST(KeptDecisions, EndIfABlockOrANeighbourHasSplit) {
  std::vector<NearPair> pairs = row;
  pairs.push_back({4, 6});  // block 6 has split off block 5
  const PairIndex old = index_of(row, 6), now = index_of(pairs, 7);
  const std::vector<char> changed = {0, 0, 0, 0, 0, 1, 1};
  Decisions alone = made(old, infinite), among_others = made(old, 10.0);
  alone.keep_in(now, old, changed);
  among_others.keep_in(now, old, changed);
  EXPECT_EQ(limits_of(alone), (std::vector<double>{1, 2, 3, 4, 0, 0}));
  EXPECT_EQ(limits_of(among_others), (std::vector<double>{1, 2, 3, 0, 0, 0}));
}

}  // namespace
}  // namespace blocks::dynamics
