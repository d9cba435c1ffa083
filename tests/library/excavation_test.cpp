// REMOVE and FREE: the motion of the blocks that remain.
#include "blocks/simulation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string gravity = "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.3\n";
/// A floor and three boxes on it, blocks 1 to 4.
const std::string stack = preliminary() + rectangle(-2, -1, 3, 0, true) +
                          rectangle(0, 0, 1, 1) + rectangle(0, 1, 1, 2) +
                          rectangle(0, 2, 1, 3) + gravity;

std::vector<double> corners(const Simulation& simulation, int first, int last) {
  std::vector<double> all;
  for (int b = first; b <= last; ++b) {
    const Eigen::Matrix2Xd of_block = simulation.corners(b);
    all.insert(all.end(), of_block.data(), of_block.data() + of_block.size());
  }
  return all;
}

// Velocities are updated first, so the fall after n steps is g dt^2 n (n + 1) / 2.
TEST(Remove, LetsTheBlocksAboveFallFreely) {
  Simulation fall(stack + "CYCLE, 500\nREMOVE, 2, 3\n");
  const double start = fall.centroid(4).y(), speed = fall.velocity(4).y();
  const int n = 200;
  fall.step(n);
  const double dt = fall.time_step();
  EXPECT_NEAR(fall.centroid(4).y(),
              start + n * dt * speed - 9.81 * dt * dt * n * (n + 1) / 2.0, 1e-12);
  EXPECT_TRUE(fall.contacts().empty());
}

// The block on top falls through the place of the removed ones to the floor.
TEST(Remove, LeavesAPlaceThatOthersMayFill) {
  Simulation fall(stack + "CYCLE, 100\nREMOVE, 2, 3\n");
  fall.step(8000);
  EXPECT_NEAR(fall.centroid(4).y(), 0.5, 0.01);
  EXPECT_NEAR(fall.velocity(4).norm(), 0.0, 1e-3);
  EXPECT_NEAR(fall.contact_force(4).y(), 9.81 * fall.mass(4), 1.0);
}

// The last block is small and would set the time step. Its removal before any motion
// leaves no trace.
TEST(Remove, BeforeAMotionGivesTheBitsOfADeckWithoutTheBlock) {
  const std::string loads = "SETVEL, 4, 0, 0.3, 0\n";
  Simulation without(stack + loads);
  Simulation with(stack + loads + rectangle(1, 0, 1.25, 0.25) + "REMOVE, 5\n");
  EXPECT_EQ(with.time_step(), without.time_step());
  for (Simulation* one : {&without, &with})
    one->step(3000);
  EXPECT_EQ(corners(with, 1, 4), corners(without, 1, 4));
  EXPECT_EQ(with.kinetic_energy(), without.kinetic_energy());
}

TEST(Remove, KeepsTheNumbersOfOthers) {
  Simulation fall(stack + "REMOVE, 2\nCYCLE, 10\n" + rectangle(2, 0, 3, 1));
  EXPECT_EQ(fall.blocks(), 5);
  EXPECT_FALSE(fall.is_free(2));
  EXPECT_TRUE(fall.velocity(2).isZero(0.0));
  EXPECT_NEAR(fall.centroid(5).x(), 2.5, 1e-9);
}

// The small block sets the time step, so it grows when the block is removed.
TEST(Remove, LetsTheTimeStepGrow) {
  Simulation two(preliminary() + rectangle(0, 0, 1, 1) + rectangle(4, 0, 4.5, 0.5) +
                 "CYCLE, 3\n");
  const double small = two.time_step(), before = two.time();
  two.cards("REMOVE, 2");
  EXPECT_NEAR(two.time_step(), 2.0 * small, 1e-15);
  two.step();
  EXPECT_NEAR(two.time() - before, 2.0 * small, 1e-15);
}

TEST(Remove, DeletesLoads) {
  Simulation pushed(preliminary("RIGID\nFUNCTION, 2\n0, 1\n1, 1\n") +
                    rectangle(0, 0, 1, 1) + rectangle(4, 0, 5, 1) +
                    "FORCE, 1, 10, 0\nPRESSBC, 1, 1, 10, 10\nCYCLE, 5\nREMOVE, 1\n");
  const Eigen::Vector2d place = pushed.centroid(1);
  pushed.step(10);
  EXPECT_EQ(pushed.centroid(1), place);
  EXPECT_TRUE(pushed.force(1).isZero(0.0));
}

TEST(Remove, ThrowsIfNothingRemainsToMove) {
  Simulation gone(stack + "REMOVE, 1, -1\n");
  EXPECT_THROW(gone.step(), std::logic_error);
  EXPECT_THROW(gone.set_velocity(2, {1, 0}), std::logic_error);
  EXPECT_EQ(gone.kinetic_energy(), 0.0);
}

// Both boxes are in the box of the outline. The second reaches beyond its slanted side.
TEST(Remove, TakesBlocksEntirelyInsideAnOutline) {
  const std::string two = preliminary() + rectangle(0, 0, 1, 1) + rectangle(2, 0, 3, 1);
  Simulation some(two + "REMOVE, , , , 4\n0, 0, 1, 3\n0, 1, 1, 0\n");
  EXPECT_FALSE(some.is_free(1));
  EXPECT_TRUE(some.is_free(2));
  Simulation both(two + "REMOVE, , , , 4\n3, 3, 0, 0\n0, 1, 1, 0\n");
  EXPECT_FALSE(both.is_free(1));
  EXPECT_FALSE(both.is_free(2));
}

// The corners on the slanted line are rounded, some of them to its outer side.
TEST(Remove, ForgivesTheRoundingOfCornersOnSlantedLines) {
  const std::string layer = preliminary() + "LAYER, -7, 1, 0, 0.1, 0.3, 1.4, 7.3, 2.7, "
                                            "7, 0.9\n";
  Simulation slope(layer + "REMOVE, , , , 4\n0, 0.3, 7.3, 7\n0.1, 1.4, 2.7, 0.9\n");
  for (int b = 1; b <= 7; ++b)
    EXPECT_FALSE(slope.is_free(b)) << b;
}

TEST(Remove, TakesTheBlocksWhereTheyAre) {
  Simulation moved(preliminary() + rectangle(0, 0, 1, 1) + rectangle(4, 0, 5, 1) +
                   "SETVEL, 2, 0, 2, 0\nMOTION, 1\n"
                   "REMOVE, , , , 4\n5.9, 5.9, 7.1, 7.1\n-1, 2, 2, -1\n");
  EXPECT_TRUE(moved.is_free(1));
  EXPECT_FALSE(moved.is_free(2));
}

TEST(Remove, TakesAMaterial) {
  Simulation some(preliminary() + rectangle(0, 0, 1, 1) +
                  "CREATE, 4, 2\n2, 2, 3, 3\n0, 1, 1, 0\nREMOVE, , , 2\n");
  EXPECT_TRUE(some.is_free(1));
  EXPECT_FALSE(some.is_free(2));
}

// The middle box is held by a bolt; its weight goes to the bolt until it is freed.
TEST(Free, LetsAFixedBlockMove) {
  Simulation held(stack + "FIX, 4\nREMOVE, 2, 3\nCYCLE, 50\n");
  const double y = held.centroid(4).y();
  EXPECT_EQ(y, 2.5);
  held.cards("FREE, 4");
  const int n = 100;
  held.step(n);
  const double dt = held.time_step();
  EXPECT_NEAR(held.centroid(4).y(), y - 9.81 * dt * dt * n * (n + 1) / 2.0, 1e-12);
}

// A fixed block that is freed before any motion was never different from a free one.
TEST(Free, BeforeAMotionUndoesFix) {
  Simulation free(stack), freed(stack + "FIX, 3\nFIX, 4\nFREE, 3, -1\n");
  for (Simulation* one : {&free, &freed})
    one->step(1000);
  EXPECT_EQ(corners(freed, 1, 4), corners(free, 1, 4));
}

// The thin block needs a shorter time step as soon as it may deform.
TEST(Free, ShortensTheTimeStepOfDeformableBlocks) {
  const std::string two = preliminary("") + rectangle(0, 0, 1, 1) +
                          rectangle(4, 0, 5, 0.001, true) + "CYCLE, 2\n";
  Simulation thin(two);
  const double before = thin.time_step();
  thin.cards("FREE, 2");
  EXPECT_LT(thin.time_step(), before);
  Simulation free(preliminary("") + rectangle(0, 0, 1, 1) + rectangle(4, 0, 5, 0.001));
  EXPECT_EQ(thin.time_step(), free.time_step());
}

}  // namespace
}  // namespace blocks::testing
