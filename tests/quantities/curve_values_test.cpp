// Values of curves agree with those worked out by hand.
#include "quantities/curve_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blocks::quantities {
namespace {

/// Five unit squares beside each other with y = 0.5, 1.5, ... and materials 1, 1, 2, 2,
/// 2. Block i has the velocity (i, 0).
Model stairs() {
  Model model;
  for (int i = 0; i < 5; ++i) {
    const double x = 2.0 * i, y = i;
    model.blocks.append(
        {{{{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}}, i < 2 ? 1 : 2, 1.0}});
    model.blocks.velocity.col(i) = Vec2(i + 1, 0);
  }
  return model;
}

double value(const Model& model, const std::string& curve,
             const MaterialNumbers& numbers = {}) {
  static const Model start = stairs();
  CurveValues values({parse_curve(curve)}, numbers);
  std::vector<ContactState> contacts;
  list_contacts(model, contacts);
  double result = 0.0;
  values.evaluate({model.time, model.steps, states_of(model.blocks), contacts},
                  states_of(start.blocks), {&result, 1});
  return result;
}

TEST(CurveValues, ReduceGroupsOfBlocks) {
  const Model model = stairs();
  EXPECT_EQ(value(model, "y:2"), 1.5);
  EXPECT_EQ(value(model, "y:2-4"), 2.5);
  EXPECT_EQ(value(model, "y:2-4:max"), 3.5);
  EXPECT_EQ(value(model, "y:2-4:min"), 1.5);
  EXPECT_EQ(value(model, "y:1-5:p25"), 1.5);
  EXPECT_EQ(value(model, "mass:2-4:sum"), 3.0);
  EXPECT_EQ(value(model, "y:material=2"), 3.5);
  EXPECT_EQ(value(model, "y:material=old", {{"old", 1}}), 1.0);
  EXPECT_EQ(value(model, "speed:mean"), 3.0);
  EXPECT_EQ(value(model, "ke"), 0.5 * (1 + 4 + 9 + 16 + 25));
  EXPECT_EQ(value(model, "x:3.4"), 5.0);
}

TEST(CurveValues, OfBlocksThatDoNotExistYetAreNone) {
  const Model model = stairs();
  EXPECT_TRUE(std::isnan(value(model, "y:6")));
  EXPECT_TRUE(std::isnan(value(model, "y:6-7")));
  EXPECT_EQ(value(model, "y:5-7"), 4.5) << "the mean of those that exist";
}

TEST(CurveValues, LeaveRemovedBlocksOut) {
  Model model = stairs();
  model.blocks.fixity[2] = Fixity::removed;
  EXPECT_TRUE(std::isnan(value(model, "y:3")));
  EXPECT_TRUE(std::isnan(value(model, "y:3.1")));
  EXPECT_EQ(value(model, "y:2-4"), (1.5 + 3.5) / 2);
  EXPECT_EQ(value(model, "y:material=2"), 4.0);
  EXPECT_EQ(value(model, "mass"), 4.0);
  EXPECT_EQ(value(model, "blocks"), 4.0);
}

TEST(CurveValues, MeasureDisplacementsFromTheFirstPositions) {
  Model model = stairs();
  model.blocks.centroid.col(1) += Vec2(3, 4);
  model.blocks.corner.row(1).array() += 2.0;
  model.blocks.append({{{{20, 0}, {20, 1}, {21, 1}, {21, 0}}, 1, 1.0}});
  EXPECT_EQ(value(model, "displacement:2"), 5.0);
  EXPECT_EQ(value(model, "dy:1.1"), 2.0);
  EXPECT_EQ(value(model, "displacement:6"), 0.0) << "made later";
  EXPECT_EQ(value(model, "dy:6.1"), 0.0);
}

/// Three contacts: two of joint 7 between blocks 1 and 2, one without a law between
/// blocks 2 and 3.
Model jointed_stairs() {
  Model model = stairs();
  model.contacts = {{0, 4, 0, 0, 30.0, -5.0, 0.25},
                    {5, 1, 0, 0, 10.0, 1.0, 0.125},
                    {4, 8, 0, 0, 2.0, 4.0, 0.5}};
  LawState one;
  one.law = 7, one.bonded = true, one.failed = true;
  one.slip = -3.0, one.offset = 0.5, one.length = 1.5;
  LawState two;
  two.law = 7, two.bonded = true, two.slip = 1.0, two.length = 0.5;
  model.law_states = {one, two, {}};
  return model;
}

TEST(CurveValues, ReduceContactsToJointsAndPairsOfBlocks) {
  const Model model = jointed_stairs();
  EXPECT_EQ(value(model, "bonded"), 2.0);
  EXPECT_EQ(value(model, "failed"), 1.0);
  EXPECT_EQ(value(model, "slip"), 3.0) << "the largest size";
  EXPECT_EQ(value(model, "slip:1"), 3.0);
  EXPECT_EQ(value(model, "slip:joint=7"), -1.0) << "the mean with its sign";
  EXPECT_EQ(value(model, "slip:1+2:max"), 1.0);
  EXPECT_EQ(value(model, "dilation:joint=7"), 0.25);
  EXPECT_EQ(value(model, "joint_length:joint=7"), 2.0);
  EXPECT_EQ(value(model, "contacts:joint=7"), 2.0);
  EXPECT_EQ(value(model, "shear_force"), 10.0) << "the sum of sizes";
  EXPECT_EQ(value(model, "shear_force:1+2"), -4.0);
  EXPECT_EQ(value(model, "shear_force:2+3"), 4.0) << "without a law too";
  EXPECT_EQ(value(model, "normal_force:2+1"), 40.0);
  EXPECT_EQ(value(model, "overlap:1+2"), 0.25);
  EXPECT_EQ(value(model, "normal_stress:joint=7"), 20.0);
  EXPECT_EQ(value(model, "shear_stress:1+2"), -2.0);
}

TEST(CurveValues, OfJointsWithoutContactsAreNoneUnlessTheyAreSums) {
  const Model model = jointed_stairs();
  EXPECT_EQ(value(model, "normal_force:joint=8"), 0.0);
  EXPECT_EQ(value(model, "normal_stress:joint=8"), 0.0);
  EXPECT_EQ(value(model, "normal_stress:2+3"), 0.0) << "it has no length";
  EXPECT_TRUE(std::isnan(value(model, "slip:joint=8")));
  EXPECT_TRUE(std::isnan(value(model, "overlap:1+5")));
}

// Corner 0 of block 1 acts on block 2 and corner 1 on a plane. Block 3 has no contact.
TEST(CurveValues, ReduceContactsToBlocks) {
  Model model = stairs();
  model.contacts = {{0, 4, 0, 0, 30.0, -5.0, 0.25}};
  model.plane_contacts = {{0, 1, true, 0.0, 10.0, 0.125},
                          {0, 2, false, 0.0, 1000.0, 1000.0}};
  EXPECT_EQ(value(model, "contacts"), 2.0);
  EXPECT_EQ(value(model, "overlap"), 0.25);
  EXPECT_EQ(value(model, "overlap:mean"), 0.1875);
  EXPECT_EQ(value(model, "normal_force:1"), 40.0);
  EXPECT_EQ(value(model, "shear_force:2"), 5.0);
  EXPECT_EQ(value(model, "normal_force:3"), 0.0);
  EXPECT_EQ(value(model, "normal_force:1-3:mean"), (40.0 + 30.0 + 0.0) / 3);
  EXPECT_EQ(value(stairs(), "overlap:max"), 0.0);
}

}  // namespace
}  // namespace blocks::quantities
