// How contacts are arranged in batches, and what a new decision changes there.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"

namespace blocks::dynamics {
namespace {

/// Squares side by side, of two materials in a random order.
Blocks row_of_squares(int count, std::mt19937& random) {
  Blocks blocks;
  for (int b = 0; b < count; ++b) {
    NewBlock block;
    const double x = b;
    block.outline = {{x, 0}, {x, 1}, {x + 1, 1}, {x + 1, 0}};
    block.density = 1.0;
    block.material = static_cast<int>(random() % 2);
    blocks.append({block});
  }
  return blocks;
}

PairIndex neighbours_in_row(int blocks) {
  std::vector<NearPair> pairs;
  for (int b = 1; b < blocks; ++b)
    pairs.push_back({b - 1, b});
  PairIndex index;
  index.take(pairs, blocks);
  return index;
}

// Whatever pairs have laws and however many contacts they have, each pair finds its
// contacts in its own slots, in order.
TEST(ContactArrays, GiveEveryPairItsSlots) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int count = 2 + static_cast<int>(random() % 700);
    const Blocks blocks = row_of_squares(count, random);
    Settings settings;
    settings.in_situ = random() % 4 == 0;
    if (random() % 2 == 0) {
      settings.joint_laws[1].normal_stiffness = 1e9;
      settings.joint_of_materials[{0, 1}] = 1;
    }
    ContactsOfPairs contacts;
    const PairIndex index = neighbours_in_row(count);
    std::vector<std::vector<PairContact>> given(static_cast<std::size_t>(index.size()));
    const auto largest = 1 + random() % 12;
    for (int p = 0; p < index.size(); ++p) {
      for (auto i = random() % largest; i > 0; --i)
        given[p].push_back({{.at = {4 * p + static_cast<int>(random() % 4),
                                    4 * p + 4 + static_cast<int>(random() % 4)},
                             .tested = random() % 2 == 0}});
      if (!given[p].empty())
        contacts.add(p, given[p], settings.in_situ || !settings.joint_laws.empty());
    }
    ContactArrays arrays;
    arrays.slots_of_pair.assign(static_cast<std::size_t>(index.size()), 0);
    arrays.make(blocks, settings, index, contacts, {});
    std::set<int> used;
    for (int p = 0; p < index.size(); ++p) {
      std::size_t i = 0;
      arrays.each_slot(p, [&](int slot) {
        ASSERT_TRUE(used.insert(slot).second);
        ASSERT_LT(slot, lane_count * arrays.batches.rows());
        ASSERT_EQ(arrays.is_vacant(slot), i >= given[p].size());
        if (i < given[p].size()) {
          ASSERT_EQ(arrays.at(slot), given[p][i].at);
          ASSERT_EQ(arrays.batches.is(slot, &ContactTests::tested), given[p][i].tested);
        }
        ++i;
      });
      ASSERT_GE(i, given[p].size());
    }
  }
}

// After INSITU a pair gets the partners of its contacts with its first decision,
// whether or not it has slots, so it does not matter how the arrays were made.
TEST(ContactArrays, GivePartnersToPairsWithoutSlots) {
  std::mt19937 random(1);
  const Blocks blocks = row_of_squares(2, random);
  const PairIndex index = neighbours_in_row(2);
  Settings settings;
  settings.in_situ = true;
  ContactArrays arrays;
  arrays.slots_of_pair = {0};
  arrays.make(blocks, settings, index, {}, {});
  ContactChanges changes;
  // the upper corner of block 1 on the right side of block 0
  arrays.assign(blocks, index, 0, {{5, 2}}, true, changes);
  ASSERT_EQ(changes.grown.pair, std::vector<int>{0});
  ASSERT_EQ(changes.grown.all.size(), 2U);
  EXPECT_EQ(changes.grown.at(0).at, (CornerOnEdge{2, 4}));
  EXPECT_EQ(changes.grown.at(1).at, (CornerOnEdge{5, 2}));
}

// A corner that is bonded acts on no other edge of the block, even if an offset would
// hold it there or it is a partner. It may be bonded to both edges at a bend.
TEST(ContactArrays, KeepABondedCornerOnItsEdges) {
  std::mt19937 random(1);
  const Blocks blocks = row_of_squares(2, random);
  const PairIndex index = neighbours_in_row(2);
  Settings settings;
  settings.in_situ = true;
  const CornerOnEdge first{5, 1}, second{5, 2};
  for (const bool is_bend : {false, true}) {
    PairContact one{{.at = first, .acted = true, .normal = 1.0}},
        other{{.at = second, .acted = true, .normal = 1.0}};
    one.law_state.offset = 0.1, one.law_state.bonded = is_bend;
    other.law_state.bonded = true;
    ContactsOfPairs contacts;
    contacts.add(0, {one, other}, true);
    ContactArrays arrays;
    arrays.slots_of_pair = {6};
    arrays.make(blocks, settings, index, contacts, {});
    ContactChanges changes;
    arrays.assign(blocks, index, 0, {first, second}, true, changes);
    std::vector<CornerOnEdge> kept;
    arrays.each_slot(0, [&](int slot) {
      if (!arrays.is_vacant(slot) && arrays.at(slot).corner == 5)
        kept.push_back(arrays.at(slot));
    });
    EXPECT_EQ(kept, is_bend ? (std::vector<CornerOnEdge>{first, second})
                            : (std::vector<CornerOnEdge>{second}));
    EXPECT_EQ(changes.released.size(), is_bend ? 0U : 1U);
  }
}

}  // namespace
}  // namespace blocks::dynamics
