// The local ratio: how far single blocks are from equilibrium, and which blocks count.
#include "model/local_ratio.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/drives.hpp"
#include "tools/rectangle.hpp"

namespace blocks {
namespace {

using testing::rectangle;

/// Three free blocks of weight 4 that touch nothing.
Model three_blocks() {
  Model model;
  model.settings.rigid = true;
  model.settings.gravity = {0.0, -1.0};
  for (const double x : {0.0, 5.0, 10.0})
    model.blocks.append({rectangle(x, 0, 2, 2)});
  model.blocks.force.setZero();
  model.blocks.moment.setZero();
  return model;
}

Eigen::VectorXd ratios_of(const Model& model) {
  Eigen::VectorXd ratios;
  local_ratios(model, ratios);
  return ratios;
}

TEST(LocalRatio, IsOneInFreeFallAndZeroForBlocksThatCannotFall) {
  Model model = three_blocks();
  model.blocks.fixity[1] = Fixity::by_user;
  model.blocks.fixity[2] = Fixity::driven;
  model.drives = {{2, {0, 0}, 0.0}};
  EXPECT_EQ(ratios_of(model), Eigen::Vector3d(1, 0, 0));
  model.blocks.fixity[0] = Fixity::removed;
  const Balance balance = balance_of(model);
  EXPECT_EQ(balance.local, 0.0);
  EXPECT_EQ(balance.block, -1);
}

// A weight of 4 acts downwards, a contact force of 3 upwards, 2 of it from the dashpot,
// and a load of 2 to the side. The resultant is (2, -1), and the sizes add up to 9.
TEST(LocalRatio, CountsAllForcesWithTheirDashpots) {
  Model model = three_blocks();
  model.contacts = {{0, 4, 1.0, 0.0, 3.0, 0.0, 0.1}};  // blocks 1 and 2
  model.blocks.force.col(0) = Vec2(2, 3);
  model.blocks.force.col(1) = Vec2(0, -3);
  model.loads.forces = {{0, {2, 0}, TimeFunction::always}};
  const Eigen::VectorXd ratios = ratios_of(model);
  EXPECT_NEAR(ratios[0], std::sqrt(5.0) / 9, 1e-15);
  EXPECT_NEAR(ratios[1], 7.0 / 7, 1e-15);  // the contact pushes it downwards
}

// A block that begins to topple may have no resultant.
TEST(LocalRatio, CountsMoments) {
  Model model = three_blocks();
  model.blocks.force.col(0) = Vec2(0, 4);
  model.contacts = {{0, 4, 4.0, 0.0, 4.0, 0.0, 0.1}};
  model.blocks.moment[0] = 4.0;
  const double gyration = std::sqrt(model.blocks.inertia[0] / model.blocks.mass[0]);
  EXPECT_NEAR(ratios_of(model)[0], 4.0 / gyration / 8.0, 1e-15);
}

// Without gravity a block may touch others with forces that are rounding.
TEST(LocalRatio, IgnoresForcesThatAreRounding) {
  Model model = three_blocks();
  model.settings.gravity = {0, 0};
  EXPECT_EQ(ratios_of(model), Eigen::Vector3d::Zero());
  model.loads.forces = {{0, {1.0, 0}, TimeFunction::always},
                        {1, {1e-10, 0}, TimeFunction::always}};
  model.blocks.force.col(0) = Vec2(1.0, 0);
  model.blocks.force.col(1) = Vec2(1e-10, 0);
  EXPECT_EQ(ratios_of(model), Eigen::Vector3d(1, 0, 0));
  model.loads.forces[1].force.x() = model.blocks.force(0, 1) = 1e-8;
  EXPECT_EQ(ratios_of(model), Eigen::Vector3d(1, 1, 0));
}

TEST(Balance, NamesTheFirstOfTheWorstBlocks) {
  Model model = three_blocks();
  model.blocks.force.col(0) = Vec2(0, 4);
  const Balance balance = balance_of(model);
  EXPECT_EQ(balance.local, 1.0);
  EXPECT_EQ(balance.block, 1);
  EXPECT_NEAR(balance.ratio, 8.0 / 12.0, 1e-15);
}

}  // namespace
}  // namespace blocks
