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

// What is listed no more has no forces; all others keep theirs, with their new places
// in the list.
TEST(Search, ForgetsTheForcesOfWhatIsListedNoMore) {
  Model model = settled_wall().model;
  const Contacts before = model.contacts;
  const int gone = 20;
  model.blocks.corner.middleCols(model.blocks.first_corner[gone], 4).array() += 50.0;
  model.blocks.centroid.col(gone).array() += 50.0;
  const auto of_gone = [&](const Contacts& list, int i) {
    return model.blocks.corner_block[list.corner[i]] == gone ||
           model.blocks.corner_block[list.edge[i]] == gone;
  };
  std::vector<ActingContact> expected;
  for (const ActingContact& contact : before.acting)
    if (!of_gone(before, contact.record))
      expected.push_back(contact);
  ASSERT_LT(expected.size(), before.acting.size());
  dynamics::SearchBuffers buffers;
  dynamics::update_contacts(model, buffers);
  const Contacts& after = model.contacts;
  ASSERT_EQ(after.acting.size(), expected.size());
  EXPECT_EQ(std::count(after.active.begin(), after.active.end(), 1),
            static_cast<long>(expected.size()));
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const int now = after.acting[k].record, then = expected[k].record;
    EXPECT_EQ(after.active[now], 1);
    EXPECT_EQ(after.corner[now], before.corner[then]);
    EXPECT_EQ(after.edge[now], before.edge[then]);
    expected[k].record = now;
    EXPECT_EQ(after.acting[k], expected[k]);
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
