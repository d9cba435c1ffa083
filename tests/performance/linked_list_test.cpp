// The code that speed is measured against computes the same as the program: a ratio of
// times means nothing between codes that compute different things.
#include <gtest/gtest.h>

#include <cmath>

#include "blocks_code.hpp"
#include "dynamics/step.hpp"
#include "linked_list.hpp"
#include "study/corner_rules/corner_rules.hpp"
#include "wall.hpp"

namespace blocks {
namespace {

double largest_difference(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Linked lists decide corner by corner, and a spring ends with its contact.
struct CornersWithoutTransfer : study::CornerRules {
  static constexpr bool transfers_springs = false;
};

// By these rules every contact is the same in both codes, so only the order of sums
// differs.
TEST(LinkedLists, MoveTheWallAsTheProgramDoesWithoutHandOver) {
  Model wall = bench::wall_of_power(2);
  bench::LinkedListCode lists(wall);
  dynamics::Workspace work;
  dynamics::prepare(wall);
  const Eigen::Matrix2Xd start = wall.blocks.corner;
  for (int i = 0; i < 500; ++i)
    dynamics::step_by(CornersWithoutTransfer(), wall, work);
  lists.run(500);
  EXPECT_GT(largest_difference(start, lists.corners()), 1e-5);
  EXPECT_EQ(lists.acting_contacts(), totals(wall).active_contacts);
  EXPECT_LT(largest_difference(wall.blocks.corner, lists.corners()), 1e-13);
}

// With the contact rule of runs and the transfer of springs, what differs is small
// against the movement.
TEST(LinkedLists, MoveTheWallNearlyAsTheProgramDoes) {
  bench::BlocksCode ours(bench::wall_of_power(2));
  bench::LinkedListCode lists(bench::wall_of_power(2));
  const Eigen::Matrix2Xd start = lists.corners();
  ours.run(300);
  lists.run(300);
  const double moved = largest_difference(start, lists.corners());
  EXPECT_LT(largest_difference(ours.model().blocks.corner, lists.corners()),
            0.05 * moved);
}

// A code that starts in the middle of a run takes over the springs.
TEST(LinkedLists, GoOnFromTheSpringsOfAModel) {
  bench::BlocksCode ours(bench::wall_of_power(2));
  ours.run(2000);
  bench::LinkedListCode lists(ours.model());
  const Eigen::Matrix2Xd start = lists.corners();
  ours.run(20);
  lists.run(20);
  // without them the bricks would fall as if they stood on nothing
  const double free_fall = 0.5 * 9.81 * std::pow(20 * ours.model().time_step.dt, 2);
  EXPECT_LT(largest_difference(ours.model().blocks.corner, lists.corners()),
            0.01 * free_fall);
}

}  // namespace
}  // namespace blocks
