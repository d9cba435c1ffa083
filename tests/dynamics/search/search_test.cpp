// The search for near pairs keeps the contacts and is rare.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

/// A wall that has settled a little, so that many of its contacts act.
scenes::Scene settled_wall() {
  scenes::Scene scene;
  scene.model.settings.friction = 0.5;
  scene.box(-1, -1, 12, 1, true);
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 8; ++i)
      scene.box(i + 0.5 * (row % 2), 0.5 * row, 1, 0.5);
  scene.gravity(1, -10);
  scene.run(0.02);
  return scene;
}

// A search before every step changes neither the contacts nor their springs.
TEST(Search, KeepsContactsAndSprings) {
  scenes::Scene scene = settled_wall();
  Model again = scene.model;
  ASSERT_GT(again.contacts.size(), 60U);
  dynamics::Workspace work;
  for (int i = 0; i < 20; ++i) {
    scene.step();
    again.search.invalidate();
    dynamics::step(again, work);
    ASSERT_EQ(again.contacts, scene.model.contacts);
    ASSERT_EQ(again.blocks.corner, scene.model.blocks.corner);
  }
}

// The blocks of a contact are sorted with the lower number first.
TEST(Search, SortsContactsByBlocksCornerAndEdge) {
  const Model model = settled_wall().model;
  std::vector<std::tuple<int, int, int, int>> keys;
  for (const Contact& contact : model.contacts) {
    const auto [low, high] = std::minmax(model.blocks.corner_block[contact.corner],
                                         model.blocks.corner_block[contact.edge]);
    keys.emplace_back(low, high, contact.corner, contact.edge);
  }
  EXPECT_GT(keys.size(), 60U);
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
}

TEST(Search, DropsContactsOfABlockThatWasMovedAway) {
  Model model = settled_wall().model;
  const int gone = 20;
  model.blocks.corner.middleCols(model.blocks.first_corner[gone], 4).array() += 50.0;
  model.blocks.centroid.col(gone).array() += 50.0;
  model.search.invalidate();
  dynamics::Workspace work;
  dynamics::step(model, work);
  EXPECT_GT(model.contacts.size(), 50U);
  for (const Contact& contact : model.contacts) {
    EXPECT_NE(model.blocks.corner_block[contact.corner], gone);
    EXPECT_NE(model.blocks.corner_block[contact.edge], gone);
  }
}

TEST(Search, DropsContactsBetweenFixedBlocks) {
  Model model = settled_wall().model;
  ASSERT_FALSE(model.contacts.empty());
  for (int b = 0; b < model.blocks.size(); ++b)
    model.blocks.fix(b, Fixity::by_user);
  dynamics::Workspace others;
  dynamics::step(model, others);
  EXPECT_TRUE(model.contacts.empty());
}

// Blocks move by a large part of their size in a step.
TEST(Search, ResultsOfFastBlocksDoNotDependOnTolerance) {
  for (int seed = 0; seed < 20; ++seed) {
    std::vector<Eigen::Matrix2Xd> ends;
    for (const double tolerance : {1e-6, 0.02, 0.1, 0.7}) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(-1, 1);
      scenes::Scene scene;
      scene.model.settings.contact_tolerance = tolerance;
      scene.model.settings.friction = 0.3;
      scene.box(-1, -1, 12, 1, true);
      scene.box(-2, 0, 1, 12, true);
      scene.box(11, 0, 1, 12, true);
      for (int i = 0; i < 16; ++i)
        scene.box(1 + 2.2 * (i % 4), 0.2 + 1.3 * (i / 4), 1, 0.7);
      scene.prepare();
      const double fast = 0.15 / scene.model.time_step.dt;
      for (int b = 3; b < scene.model.blocks.size(); ++b)
        scene.velocity(b, fast * uniform(random), fast * uniform(random),
                       fast * uniform(random));
      scene.steps(150);
      ends.push_back(scene.model.blocks.corner);
    }
    for (const Eigen::Matrix2Xd& end : ends)
      EXPECT_EQ(end, ends.front()) << seed;
  }
}

// The list of near pairs is made for a larger distance if blocks are fast, so it
// remains valid for many steps.
TEST(Search, IsRareForAnySmallTolerance) {
  std::vector<Eigen::Matrix2Xd> ends;
  for (const double tolerance : {0.05, 1e-3, 1e-6}) {
    scenes::Scene scene;
    scene.model.settings.contact_tolerance = tolerance;
    scene.model.settings.damping = 0.3;
    scene.box(-1, -1, 12, 1, true);
    for (int i = 0; i < 8; ++i)
      scene.velocity(scene.box(i * 1.2, 0.3 + 0.1 * i, 1, 0.5), 0.5, -2, 0.2 * i);
    scene.gravity(0, -10);
    scene.run(0.5);
    EXPECT_LT(scene.model.search.updates, 40);
    EXPECT_LT(40 * scene.model.search.updates, scene.model.steps);
    ends.push_back(scene.model.blocks.corner);
  }
  for (const Eigen::Matrix2Xd& end : ends)
    EXPECT_EQ(end, ends.front());
}

}  // namespace
}  // namespace blocks
