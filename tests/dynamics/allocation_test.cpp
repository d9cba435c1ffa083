// A step allocates memory only at a search for near pairs; and how much a model needs.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <utility>
#include <vector>

#include "model/drives.hpp"
#include "scenes/scene.hpp"
#include "tools/sanitized.hpp"

#if defined(__GLIBC__) && !defined(BLOCKS_SANITIZED)

// Eigen calls malloc directly, so that a replaced operator new would not count it.
extern "C" void* __libc_malloc(std::size_t size);
namespace {
std::atomic<long> allocations = 0;
}
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}

namespace blocks {
namespace {

TEST(Step, AllocatesNothingBetweenSearches) {
  for (const auto& [rigid, with_law] :
       {std::pair(true, false), {false, false}, {true, true}, {false, true}}) {
    scenes::Scene scene;
    Settings& s = scene.model.settings;
    s.rigid = rigid;
    if (with_law) {
      s.joint_laws[1] = {.friction = 0.3, .residual_friction = 0.3, .dilation = 0.1};
      s.joint_of_materials[{1, 1}] = 1;
    }
    s.friction = 0.3, s.damping = 0.3;
    scene.box(-10, -1, 20, 1, true);
    for (int row = 0; row < 6; ++row)
      for (int i = 0; i < 6; ++i)
        scene.add({{i + 0.1 * row, row * 1.02},
                   {i + 0.1 + 0.1 * row, row * 1.02 + 1},
                   {i + 0.9 + 0.1 * row, row * 1.02 + 1},
                   {i + 0.95 + 0.1 * row, row * 1.02}});
    scene.plane({-9, 5}, {-9, -5});
    scene.gravity(0.5, -10);
    scene.run(0.3);
    long searches = 0, quiet = 0, grown = 0;
    for (int i = 0; i < 2000; ++i) {
      const long updates = scene.model.search.updates, before = allocations;
      scene.step();
      if (scene.model.search.updates != updates)
        ++searches;
      else if (allocations != before)
        ++grown;  // A pair has more contacts than ever before since the search.
      else
        ++quiet;
    }
    EXPECT_GT(quiet, 1500);
    EXPECT_LT(grown, 40);
    EXPECT_GT(totals(scene.model).active_contacts, 20);
    EXPECT_LT(searches, 200);
    EXPECT_GT(allocations, 0);  // The replaced malloc counts.
  }
}

TEST(Step, AllocatesNothingUnderAServo) {
  for (const bool with_law : {false, true}) {
    scenes::Scene scene;
    if (with_law) {
      scene.model.settings.joint_laws[1] = {.friction = 0.3, .residual_friction = 0.3};
      scene.model.settings.joint_of_materials[{1, 1}] = 1;
    }
    scene.box(-2, -1, 4, 1, true);
    scene.box(-1, 0, 2, 1);
    scene.box(-1, 1, 2, 1, true);
    start_servo(scene.model, {2, 3, -1e4, 1.0});
    scene.steps(100);
    for (int i = 0; i < 500; ++i) {
      const long before = allocations, updates = scene.model.search.updates;
      scene.step();
      ASSERT_TRUE(allocations == before || scene.model.search.updates != updates);
    }
    EXPECT_LT(scene.model.search.updates, 5);
  }
}

// Corners are near each other, but no contact acts.
TEST(Step, AllocatesNothingIfNoContactActs) {
  scenes::Scene scene;
  scene.model.settings.rigid = true;
  scene.model.settings.contact_tolerance = 0.1;
  scene.box(0, 0, 1, 1);
  scene.box(1.1, 1.1, 1, 1);
  scene.step();
  for (int i = 0; i < 500; ++i) {
    const long before = allocations;
    scene.step();
    ASSERT_EQ(allocations, before) << "step " << i;
  }
  EXPECT_EQ(scene.model.search.updates, 1);
}

double bytes_in_use() {
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks) + static_cast<double>(now.hblkhd);
}

// The count has the model, its contact list, the corner-block pairs and the batches,
// after several searches.
TEST(Memory, OfABrickInAWallIsBelow3500Bytes) {
  const double before = bytes_in_use();
  scenes::Scene scene;
  scene.model.settings.rigid = true;
  scene.model.settings.contact_tolerance = 0.05;
  const int rows = 40, bricks = 50;
  scene.box(-1, -1, bricks + 2, 1, true);
  std::vector<NewBlock> wall;
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < bricks; ++i) {
      const double x = i + 0.5 * (row % 2), y = 0.5 * row;
      wall.push_back({{{x, y}, {x, y + 0.5}, {x + 1, y + 0.5}, {x + 1, y}}, 1, 2000.0});
    }
  scene.model.blocks.append(wall);
  wall = {};
  scene.gravity(0, -10);
  for (int i = 0; i < 3; ++i) {
    scene.model.search.invalidate();
    scene.steps(2);
  }
  EXPECT_GT(totals(scene.model).active_contacts, 1000);
  const double each = (bytes_in_use() - before) / (rows * bricks);
  RecordProperty("bytes_of_a_brick", std::to_string(each));
  // A brick takes 3,450 bytes with spare capacity. Forces of all potential contacts
  // would add 1,400.
  EXPECT_LT(each, 3500.0);
  EXPECT_GT(each, 1000.0);
}

TEST(Memory, IsNotTakenForContactsUntilTheyAreRead) {
  scenes::Scene scene;
  Model& model = scene.model;
  scene.box(-5, -1, 10, 1, true);
  scene.box(-1, 0, 2, 1);
  scene.gravity(0, -10);
  scene.prepare();
  dynamics::Workspace work;
  for (int k = 0; k < 20; ++k)
    dynamics::advance(model, work, false);
  EXPECT_TRUE(model.contacts.empty());
  dynamics::catch_up(model, work);
  EXPECT_EQ(model.contacts.size(), 2U);
}

}  // namespace
}  // namespace blocks

#endif
