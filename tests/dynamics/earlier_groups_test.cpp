// What is known of a pair of blocks outlives the list of contacts: nobody can tell but
// by the time it takes.
#include "dynamics/earlier_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dynamics/contact_search.hpp"
#include "dynamics/stepper.hpp"
#include "output/fields.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Scene;

/// Stones of 3 to 6 corners thrown on each other between walls, some of them notched.
Model rubble(bool rigid, double tolerance) {
  Scene scene;
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.4, s.damping = 0.2, s.contact_tolerance = tolerance;
  scene.box(-4, -1, 8, 1, true);
  scene.box(-4, 0, 1, 9, true);
  scene.box(3, 0, 1, 9, true);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 24; ++i) {
    const Vec2 centre(-2.4 + 1.6 * (i % 4), 0.7 + 1.3 * static_cast<int>(i / 4));
    const int corners = 3 + i % 4;
    geometry::Polygon stone;
    for (int k = 0; k < corners; ++k) {
      const double angle = -6.2832 * (k + 0.2 * uniform(random)) / corners;
      const double radius = i % 6 == 3 && k == 2 ? 0.2 : 0.6;
      stone.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    scene.velocity(scene.add(stone), uniform(random), uniform(random), uniform(random));
  }
  scene.gravity(1, -10);
  scene.prepare();
  return scene.model;
}

// A list every few steps, and groups that are made from nothing in every step.
TEST(EarlierGroups, ChangeNoBit) {
  for (const bool rigid : {true, false}) {
    Model kept = rubble(rigid, 2e-4), anew = kept;
    dynamics::SearchBuffers buffers;
    for (int i = 0; i < 8000; ++i) {
      if (i % 20 == 0)
        kept.search.left = anew.search.left = 0.0;  // a list is due after the step
      dynamics::step(kept, buffers);
      dynamics::SearchBuffers fresh;
      dynamics::step(anew, fresh);
    }
    EXPECT_GT(kept.search.updates, 300);
    EXPECT_GT(totals(kept).active_contacts, 15);
    EXPECT_EQ(fields(kept), fields(anew)) << (rigid ? "rigid" : "deformable");
  }
}

// Of what is certain of a heap at rest nothing is looked for anew, however often lists
// are made.
TEST(EarlierGroups, OutliveTheList) {
  Scene scene;
  scene.model.settings.damping = 0.7;
  scene.box(-1, -1, 5, 1, true);
  for (int i = 0; i < 3; ++i)
    for (int row = 0; row < 3; ++row)
      scene.box(1.02 * i + 0.05 * row, 0.5 * row, 1, 0.5);
  scene.gravity(0, -10);
  scene.steps(4000);
  dynamics::SearchBuffers buffers;
  Model& model = scene.model;
  dynamics::step(model, buffers);
  const dynamics::ContactGroups& groups = buffers.groups;
  constexpr unsigned mark = 5;  // nobody looks at it while the group is certain
  const auto marked = [&] {
    return std::count_if(
        groups.all.begin(), groups.all.end(),
        [](const dynamics::ContactGroup& group) { return group.hopeless == mark; });
  };
  for (dynamics::ContactGroup& group : buffers.groups.all)
    if (group.certain())
      group.hopeless = mark;
  const auto known = marked();
  ASSERT_GT(known, 50);
  const long updates = model.search.updates;
  for (int i = 0; i < 25; ++i) {
    model.search.left = -1.0;  // a list is due after the step
    dynamics::step(model, buffers);
    dynamics::step(model, buffers);
  }
  EXPECT_EQ(model.search.updates, updates + 25);
  EXPECT_GT(10 * marked(), 9 * known);
  model.search.current = false;  // for a reason that is not known
  dynamics::step(model, buffers);
  EXPECT_EQ(marked(), 0);
}

// Who says that blocks were changed gets what follows from where they are now.
TEST(EarlierGroups, AreForgottenWhereBlocksWereChanged) {
  Model kept = rubble(true, 2e-4);
  dynamics::SearchBuffers buffers;
  dynamics::Stepper stepper(kept, buffers);
  do
    stepper.advance(false);
  while (kept.search.current || kept.steps < 8000);
  stepper.up_to_date();
  Blocks& blocks = kept.blocks;
  for (int b = 3; b < blocks.size(); b += 2) {  // upside down, at the same angle
    const int first = blocks.first_corner[b], count = blocks.corners_of(b);
    auto arms = blocks.arm.middleCols(first, count);
    arms = (-arms).eval();
    blocks.corner.middleCols(first, count) = arms.colwise() + blocks.centroid.col(b);
  }
  Model anew = kept;
  stepper.changed();
  stepper.advance(true);
  stepper.up_to_date();
  dynamics::SearchBuffers fresh;
  dynamics::step(anew, fresh);
  EXPECT_GT(totals(anew).active_contacts, 5);
  EXPECT_EQ(fields(kept), fields(anew));
}

/// Two boxes, one above the other, and the list of their contacts: four corners beside
/// an edge, each of which knows a travel of its own.
struct TwoBoxes {
  Scene scene;
  dynamics::SearchBuffers buffers;
  Contacts before;

  TwoBoxes() {
    scene.box(0, 0, 2, 1, true);
    scene.box(0.3, 1, 1, 1);
    list({{4, 1}, {4, 3}, {7, 0}, {7, 1}, {7, 2}, {1, 7}});
    for (int g = 0; g < 3; ++g) {
      dynamics::ContactGroup& group = groups().all[g];
      group.travel = group.unasked = static_cast<float>(1 + g);
      group.set_record(group.first + (group.count > 1 ? 1 : 0));
    }
    groups().pairs[0].prompt = 0b100;
    groups().poses[0].certain = 1.0F;
    groups().limits[0] = 1.0F;
    groups().swing.way[1] = 0.25;
  }
  dynamics::ContactGroups& groups() { return buffers.groups; }
  /// Groups of the records, in the order of lists: corner, edge.
  void list(std::vector<std::array<int, 2>> records,
            dynamics::EarlierGroups* earlier = nullptr) {
    std::sort(records.begin(), records.end());
    Contacts& contacts = scene.model.contacts;
    contacts.resize(static_cast<int>(records.size()));
    for (std::size_t i = 0; i < records.size(); ++i)
      contacts.corner[i] = records[i][0], contacts.edge[i] = records[i][1];
    dynamics::group_contacts(scene.model.blocks, contacts, true, groups(), false, 1,
                             earlier);
  }
  /// The groups of another list, which know what these do.
  void next(const std::vector<std::array<int, 2>>& records) {
    dynamics::EarlierGroups earlier;
    earlier.take(groups());
    earlier.take(scene.model.contacts);
    list(records, &earlier);
  }
  /// The travel of the group of a corner, and the edge that acts; -1: none.
  std::pair<float, int> known(int corner) {
    for (const dynamics::ContactGroup& group : groups().all)
      if (const Contacts& now = scene.model.contacts; now.corner[group.first] == corner)
        return {group.travel, group.record() < 0 ? -1 : now.edge[group.record()]};
    return {-1.0F, -1};
  }
};

TEST(EarlierGroups, KnowAsMuchOfTheSameRecords) {
  TwoBoxes two;
  two.next({{1, 7}, {4, 1}, {4, 3}, {7, 0}, {7, 1}, {7, 2}});
  EXPECT_EQ(two.known(1), std::pair(1.0F, 7));
  EXPECT_EQ(two.known(4), std::pair(2.0F, 3));
  EXPECT_EQ(two.known(7), std::pair(3.0F, 1));
  EXPECT_EQ(two.groups().pairs[0].prompt, 0b100U);
  EXPECT_EQ(two.groups().prompt[0], 1);
  EXPECT_EQ(two.groups().poses[0].certain, 1.0F);
  // the way until then is behind them
  EXPECT_LE(two.groups().limits[0], 0.75F);
  EXPECT_GT(two.groups().limits[0], 0.74F);
  EXPECT_EQ(two.groups().swing.way[1], 0.0);
}

TEST(EarlierGroups, KnowNothingOfNewEdgesNorOfAnActingOneThatIsGone) {
  TwoBoxes two;
  two.next({{2, 7}, {4, 1}, {4, 2}, {4, 3}, {7, 0}, {7, 1}});
  EXPECT_EQ(two.known(2), std::pair(0.0F, -1));  // a corner that was not there
  EXPECT_EQ(two.known(4), std::pair(0.0F, -1));  // an edge more
  EXPECT_EQ(two.known(7), std::pair(3.0F, 1));   // one less, which did not act
  EXPECT_EQ(two.groups().poses[0].certain, 0.0F);
  EXPECT_EQ(two.groups().limits[0], 0.0F);
  two = {};
  two.next({{1, 7}, {4, 1}, {4, 3}, {7, 0}, {7, 2}});
  EXPECT_EQ(two.known(7), std::pair(0.0F, -1));  // that which acted
  EXPECT_EQ(two.groups().pairs[0].prompt, 0U);
  EXPECT_EQ(two.groups().prompt[0], 0);
}

}  // namespace
}  // namespace blocks
