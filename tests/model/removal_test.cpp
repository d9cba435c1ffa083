// Removing and freeing blocks: what remains of contacts, loads and the time step.
#include "model/removal.hpp"

#include <gtest/gtest.h>

namespace blocks {
namespace {

geometry::Polygon box(double x, double y) {
  return {{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}};
}

/// Three boxes in a row. Block 0 touches 1, and 1 touches 2; 1 and 2 touch a plane.
/// Each of them has a pressure and a force. Block 1 set the time step.
Model row_of_three() {
  Model model;
  model.blocks.append({{box(0, 0), 1, 2.0, Fixity::by_user},
                       {box(1, 0), 1, 2.0, Fixity::free},
                       {box(2, 0), 1, 2.0, Fixity::free}});
  model.contacts = {{2, 4, 1.0, 0.0, 1.0, 0.0, 0.1}, {6, 8, 1.0, 0.0, 1.0, 0.0, 0.1}};
  model.settings.planes = {{{5, 0}, {0, 0}}};
  model.plane_contacts = {{0, 4, true, 3.0, 5.0, 7.0}, {0, 8, true, 4.0, 6.0, 8.0}};
  for (int b = 0; b < 3; ++b) {
    model.loads.pressures.push_back({b, 0, 1.0, 1.0, 0.0});
    model.loads.forces.push_back({b, {1, 0}, 0.0});
  }
  model.time_step = {0.01, 1, 3, false};
  model.search.renew(1.0);
  model.blocks.velocity.setConstant(2.0);
  model.blocks.force.setConstant(3.0);
  model.blocks.stress.setConstant(4.0);
  return model;
}

TEST(Removal, LeavesNothingThatActsOnTheBlock) {
  Model model = row_of_three();
  remove_blocks(model, {1});
  EXPECT_EQ(model.blocks.size(), 3);
  EXPECT_EQ(model.blocks.count_present(), 2);
  EXPECT_TRUE(model.blocks.is_removed(1));
  EXPECT_FALSE(model.blocks.is_free(1));
  EXPECT_TRUE(model.contacts.empty());
  ASSERT_EQ(model.plane_contacts.size(), 1U);
  EXPECT_EQ(model.plane_contacts[0], (PlaneContact{0, 8, true, 4.0, 6.0, 8.0}));
  ASSERT_EQ(model.loads.pressures.size(), 2U);
  EXPECT_EQ(model.loads.pressures[1].block, 2);
  ASSERT_EQ(model.loads.forces.size(), 2U);
  EXPECT_TRUE(model.blocks.velocity.col(1).isZero(0.0));
  EXPECT_TRUE(model.blocks.force.col(1).isZero(0.0));
  EXPECT_TRUE(model.blocks.stress.col(1).isZero(0.0));
  EXPECT_EQ(model.blocks.velocity(0, 2), 2.0);
  EXPECT_FALSE(model.search.current);
}

TEST(Removal, KeepsTheContactsOfOthers) {
  Model model = row_of_three();
  remove_blocks(model, {0});
  ASSERT_EQ(model.contacts.size(), 1U);
  EXPECT_EQ(model.contacts[0].corner, 6);
}

TEST(Removal, AsksForAnotherTimeStepOnlyIfTheBlockHadSetIt) {
  Model model = row_of_three();
  remove_blocks(model, {2});
  EXPECT_EQ(model.time_step.blocks, 3);
  remove_blocks(model, {1});
  EXPECT_EQ(model.time_step.blocks, 0);
}

TEST(Removal, OutlinesOfRemovedBlocksAreEmpty) {
  Model model = row_of_three();
  remove_blocks(model, {1});
  const auto outlines = model.blocks.present_outlines();
  ASSERT_EQ(outlines.size(), 3U);
  EXPECT_EQ(outlines[0].size(), 4U);
  EXPECT_TRUE(outlines[1].empty());
}

// A deformable block may need a shorter time step as soon as it moves; for rigid blocks
// the time step does not depend on what is fixed.
TEST(Freeing, AsksForAnotherTimeStepOfDeformableBlocks) {
  for (const bool rigid : {false, true}) {
    Model model = row_of_three();
    model.settings.rigid = rigid;
    free_blocks(model, {0});
    EXPECT_TRUE(model.blocks.is_free(0));
    EXPECT_EQ(model.time_step.blocks, rigid ? 3 : 0);
    EXPECT_FALSE(model.search.current);
  }
}

}  // namespace
}  // namespace blocks
