// Any number of threads gives the same bits.
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

#include "dynamics/workers.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Scene;

TEST(Workers, DoEveryItemOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    dynamics::Workers workers(threads);
    for (const int count : {0, 1, 7, 100, 1001}) {
      std::vector<std::atomic<int>> done(count);
      for (int round = 0; round < 50; ++round)
        workers.each(count, 1, [&](int part, int first, int last) {
          EXPECT_LT(part, threads);
          for (int i = first; i < last; ++i)
            ++done[i];
        });
      for (const std::atomic<int>& times : done)
        ASSERT_EQ(times, 50);
    }
  }
}

/// Bricks thrown on each other, more than one thread's share of everything.
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

TEST(Threads, ChangeNoBit) {
  for (const bool rigid : {true, false}) {
    Scene one = heap(1, rigid);
    one.steps(150);
    for (const int threads : {2, 3, 4, 8}) {
      Scene many = heap(threads, rigid);
      many.steps(150);
      ASSERT_EQ(many.model.blocks.corner, one.model.blocks.corner) << threads;
      ASSERT_EQ(many.model.blocks.velocity, one.model.blocks.velocity) << threads;
      ASSERT_EQ(many.model.blocks.stress, one.model.blocks.stress) << threads;
      ASSERT_EQ(many.model.contacts.acting, one.model.contacts.acting) << threads;
      ASSERT_EQ(many.model.worst_overlap, one.model.worst_overlap) << threads;
    }
    EXPECT_GT(totals(one.model).active_contacts, 300);
  }
}

}  // namespace
}  // namespace blocks
