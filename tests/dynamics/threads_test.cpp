// Results have the same bits with any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "dynamics/step.hpp"
#include "dynamics/support/profile.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"
#include "geometry/contact_constants.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Scene;

TEST(Workers, ProcessEveryItemOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    dynamics::Workers workers(threads);
    for (const int count : {0, 1, 7, 100, 1001}) {
      std::vector<std::atomic<int>> done(count);
      std::vector<int> begins = {0};  // Shares are uneven, and some are empty.
      for (int k = 1; k < threads; ++k)
        begins.push_back(std::max(begins.back(), (k * k * count / 7) % (count + 1)));
      begins.push_back(count);
      for (int round = 0; round < 50; ++round)
        workers.each(begins, [&](int part, int first, int last) {
          EXPECT_LT(part, threads);
          EXPECT_LT(first, last + (threads == 1));
          for (int i = first; i < last; ++i)
            ++done[i];
        });
      for (const std::atomic<int>& times : done)
        ASSERT_EQ(times, 50);
    }
  }
}

// What is not inside each() is serial, on any number of threads.
TEST(Workers, MeasureTheTimeInWhichAllWork) {
  using dynamics::Profile;
  for (const int threads : {1, 2}) {
    Profile profile;
    dynamics::Workers workers(threads);
    workers.measure(&profile.in_workers);
    const auto sleep = [](int milliseconds) {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    };
    std::vector<int> begins;
    for (int k = 0; k <= threads; ++k)
      begins.push_back(k);
    {
      Profile::Timer timer(&profile, Profile::decisions);
      workers.each(begins, [&](int, int, int) { sleep(20); });
      timer.next(Profile::forces);
      sleep(20);
    }
    EXPECT_GE(profile.shared[Profile::decisions], 0.02);
    EXPECT_LE(profile.shared[Profile::decisions], profile.seconds[Profile::decisions]);
    EXPECT_EQ(profile.shared[Profile::forces], 0.0);
    EXPECT_GE(profile.seconds[Profile::forces], 0.02);
  }
}

/// Returns the pairs of each block with the next three.
std::vector<dynamics::NearPair> neighbours(int blocks) {
  std::vector<dynamics::NearPair> pairs;
  for (int b = 0; b < blocks; ++b)
    for (int other = b + 1; other < std::min(blocks, b + 4); ++other)
      pairs.push_back({.low = b, .high = other});
  return pairs;
}

TEST(WorkSplit, GivesAThreadTheBlocksOfItsPairs) {
  for (const int blocks : {0, 1, 100, 1000, 5000})
    for (const int threads : {1, 2, 3, 8}) {
      const auto pairs = neighbours(blocks);
      const int windows =
          (static_cast<int>(pairs.size()) + dynamics::pairs_of_window - 1) /
          dynamics::pairs_of_window;
      std::vector<int> first_batch = {0};  // Each window has 30 batches.
      for (int window = 0; window < windows; ++window)
        first_batch.push_back(first_batch.back() + 30);
      dynamics::WorkSplit split;
      split.start(blocks, pairs, dynamics::pairs_of_window, threads);
      split.split_batches(first_batch);
      for (const auto& [begins, count] :
           {std::pair(split.windows, windows), std::pair(split.batches, 30 * windows),
            std::pair(split.blocks, blocks)}) {
        ASSERT_EQ(begins.front(), 0);
        ASSERT_EQ(begins.back(), count);
        ASSERT_TRUE(std::is_sorted(begins.begin(), begins.end()));
        ASSERT_GE(begins.size(), 2U);
        ASSERT_LE(begins.size(), threads + 1U);
      }
      if (blocks < 5000)
        continue;
      ASSERT_EQ(split.windows.size(), threads + 1U);
      for (int k = 1; k < threads; ++k) {
        EXPECT_EQ(split.batches[k], first_batch[split.windows[k]]);
        const int pair = dynamics::pairs_of_window * split.windows[k];
        EXPECT_EQ(split.blocks[k], pairs[pair].low);
        EXPECT_NEAR(split.blocks[k], 1.0 * blocks * k / threads, 100.0);
      }
    }
}

/// Returns a heap of bricks that is large enough for several threads.
Scene heap(int threads, bool rigid) {
  Scene scene({0.3, {10, 20}}, threads);
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.5, s.damping = 0.2;
  scene.box(-2, -1, 64, 1, true);
  scene.box(-2, 0, 1, 14, true);
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 50; ++i) {
      const double lean = 0.05 * ((7 * i + 3 * row) % 5 - 2);
      const double x = i + 0.3 * (row % 2), y = 1.01 * row;
      scene.add({{x, y}, {x + lean, y + 1}, {x + 0.98 + lean, y + 1}, {x + 0.98, y}});
    }
  scene.gravity(0.5, -10);
  return scene;
}

TEST(Threads, DoNotChangeResults) {
  for (const bool rigid : {true, false}) {
    Scene one = heap(1, rigid);
    one.steps(150);
    for (const int threads : {2, 3, 4, 8}) {
      Scene many = heap(threads, rigid);
      many.steps(150);
      ASSERT_EQ(many.model.blocks.corner, one.model.blocks.corner) << threads;
      ASSERT_EQ(many.model.blocks.velocity, one.model.blocks.velocity) << threads;
      ASSERT_EQ(many.model.blocks.stress, one.model.blocks.stress) << threads;
      ASSERT_EQ(many.model.contacts, one.model.contacts) << threads;
      ASSERT_EQ(many.model.worst_overlap, one.model.worst_overlap) << threads;
    }
    EXPECT_GT(totals(one.model).active_contacts, 300);
  }
}

/// Returns a heap after 150 steps. Without `readings` the contact list of the model is
/// made at the end only.
Model stepped_by_pairs(int threads, bool rigid, bool readings) {
  Model model = heap(1, rigid).model;
  dynamics::Workspace work(threads);
  dynamics::prepare(model);
  for (int k = 0; k < 150; ++k) {
    dynamics::advance(model, work, readings || k == 149);
    if (readings)
      dynamics::catch_up(model, work);
  }
  dynamics::catch_up(model, work);
  return model;
}

TEST(Threads, DoNotChangeResultsIfContactsAreReadAtTheEnd) {
  for (const bool rigid : {true, false}) {
    const Model one = stepped_by_pairs(1, rigid, true);
    EXPECT_GT(totals(one).active_contacts, 300);
    for (const int threads : {1, 2, 3, 8}) {
      const Model many = stepped_by_pairs(threads, rigid, false);
      ASSERT_TRUE(many.blocks.corner == one.blocks.corner) << threads;
      ASSERT_TRUE(many.blocks.velocity == one.blocks.velocity) << threads;
      ASSERT_TRUE(many.blocks.stress == one.blocks.stress) << threads;
      ASSERT_TRUE(many.blocks.applied == one.blocks.applied) << threads;
      ASSERT_TRUE(many.contacts == one.contacts) << threads;
      ASSERT_TRUE(many.worst_overlap == one.worst_overlap) << threads;
    }
  }
}

// Every pair is found once. Boxes are grown by the reach of third parts.
TEST(NearPairs, AreThePairsWhoseBoundingBoxesMeet) {
  const Blocks& blocks = heap(1, true).model.blocks;
  dynamics::NearSearch memory;
  std::vector<dynamics::NearPair> found;
  for (const double reach : {0.0, 0.02, 1.5}) {
    dynamics::find_near_pairs(blocks, reach, memory, found);
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
    std::size_t next = 0;
    for (int a = 0; a < blocks.size(); ++a)
      for (int b = a + 1; b < blocks.size(); ++b) {
        const auto range = [&](int block) {
          return blocks.corner.middleCols(blocks.first_corner[block],
                                          blocks.corners_of(block));
        };
        const Eigen::Array2d gap =
            (range(a).rowwise().minCoeff() - range(b).rowwise().maxCoeff())
                .array()
                .max((range(b).rowwise().minCoeff() - range(a).rowwise().maxCoeff())
                         .array());
        const bool is_found =
            next < found.size() && found[next].low == a && found[next].high == b;
        next += is_found;
        const bool is_free = blocks.is_free(a) || blocks.is_free(b);
        const auto extents = [&](int block) {
          return (range(block).rowwise().maxCoeff() - range(block).rowwise().minCoeff())
              .sum();
        };
        const double grown =
            2.0 * reach + 1.5 * geometry::third_reach * (extents(a) + extents(b));
        if (is_free && gap.maxCoeff() <= grown) {
          ASSERT_TRUE(is_found) << a << ' ' << b;
        }
        if (!is_free || gap.maxCoeff() > grown + 1e-3) {
          ASSERT_FALSE(is_found) << a << ' ' << b;
        }
      }
    EXPECT_EQ(next, found.size());
  }
}

}  // namespace
}  // namespace blocks
