// What a search makes of the list before: the order of the new one, and what acts.
#include "dynamics/contact_search.hpp"

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

std::vector<std::tuple<int, int, int, int>> places(const Model& model) {
  const Contacts& list = model.contacts;
  std::vector<std::tuple<int, int, int, int>> all;
  for (int i = 0; i < list.size(); ++i) {
    const auto [low, high] = std::minmax(model.blocks.corner_block[list.corner[i]],
                                         model.blocks.corner_block[list.edge[i]]);
    all.emplace_back(low, high, list.corner[i], list.edge[i]);
  }
  return all;
}

// A list that is made again where nothing has moved is the same list, and what acts
// keeps its forces.
TEST(Search, MadeAgainKeepsWhatActs) {
  Model model = settled_wall().model;
  const Contacts before = model.contacts;
  ASSERT_GT(before.acting.size(), 60U);
  dynamics::SearchBuffers buffers;
  dynamics::update_contacts(model, buffers);
  EXPECT_EQ(model.contacts.corner, before.corner);
  EXPECT_EQ(model.contacts.edge, before.edge);
  EXPECT_EQ(model.contacts.active, before.active);
  EXPECT_EQ(model.contacts.acting, before.acting);
}

// Sums over the list do not depend on how its records were found.
TEST(Search, OrdersTheListHoweverItWasFound) {
  Model model = settled_wall().model;
  const Contacts before = model.contacts;
  const auto ordered = places(model);
  EXPECT_TRUE(std::is_sorted(ordered.begin(), ordered.end()));
  dynamics::SearchBuffers buffers;
  for (int i = 0; i < before.size(); ++i)
    buffers.found.push_back({before.corner[i], before.edge[i]});
  std::shuffle(buffers.found.begin(), buffers.found.end(), std::mt19937(1982));
  dynamics::adopt_list(model, buffers, 0.1);
  EXPECT_EQ(places(model), ordered);
  EXPECT_EQ(model.contacts.active, before.active);
  EXPECT_EQ(model.contacts.acting, before.acting);
}

// What acts stays listed though its block is far away, until it has been found not to
// act (rule 13): its spring may find an heir.
TEST(Search, KeepsWhatActsUntilItActsNoMore) {
  scenes::Scene scene = settled_wall();
  Model& model = scene.model;
  const Contacts before = model.contacts;
  const int gone = 20;
  model.blocks.corner.middleCols(model.blocks.first_corner[gone], 4).array() += 50.0;
  model.blocks.centroid.col(gone).array() += 50.0;
  const auto of_gone = [&](const Contacts& list, int i) {
    return model.blocks.corner_block[list.corner[i]] == gone ||
           model.blocks.corner_block[list.edge[i]] == gone;
  };
  dynamics::SearchBuffers buffers;
  dynamics::update_contacts(model, buffers);
  const Contacts after = model.contacts;
  ASSERT_EQ(after.acting.size(), before.acting.size());
  const auto ordered = places(model);
  EXPECT_TRUE(std::is_sorted(ordered.begin(), ordered.end()));
  long far = 0;
  for (std::size_t k = 0; k < before.acting.size(); ++k) {
    ActingContact expected = before.acting[k];
    const int now = after.acting[k].record, then = expected.record;
    EXPECT_EQ(after.active[now], 1);
    EXPECT_EQ(after.corner[now], before.corner[then]);
    EXPECT_EQ(after.edge[now], before.edge[then]);
    expected.record = now;
    EXPECT_EQ(after.acting[k], expected);
    far += of_gone(after, now) ? 1 : 0;
  }
  EXPECT_GT(far, 3);
  EXPECT_EQ(std::count(after.active.begin(), after.active.end(), true),
            std::ssize(after.acting));
  for (int i = 0; i < after.size(); ++i)
    EXPECT_TRUE(after.active[i] || !of_gone(after, i));
  dynamics::step(model, buffers);
  for (const ActingContact& contact : model.contacts.acting)
    EXPECT_FALSE(of_gone(model.contacts, contact.record));
  model.search.current = false;
  dynamics::step(model, buffers);
  for (int i = 0; i < model.contacts.size(); ++i)
    EXPECT_FALSE(of_gone(model.contacts, i));
}

// Nothing moves where both blocks are fixed.
TEST(Search, ForgetsWhatActsBetweenFixedBlocks) {
  Model model = settled_wall().model;
  for (int b = 0; b < model.blocks.size(); ++b)
    model.blocks.fix(b, Fixity::by_user);
  ASSERT_GT(model.contacts.acting.size(), 60U);
  dynamics::SearchBuffers buffers;
  dynamics::update_contacts(model, buffers);
  EXPECT_EQ(model.contacts.size(), 0);
  EXPECT_TRUE(model.contacts.acting.empty());
}

// Blocks that go by a good part of their size in a step feel each other the same
// whatever CTOL is.
TEST(Search, ResultsDoNotDependOnToleranceHoweverFastBlocksAre) {
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

// However small CTOL is, a list lasts for many steps: blocks that fall fast are looked
// for farther ahead, and fall as with a CTOL that suits them.
TEST(Search, IsSeldomHoweverSmallTheTolerance) {
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
