// The reference code of the benchmark computes the same motion as the program.
// Otherwise the ratio of their times would have no meaning.
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

/// The rules of the linked lists: each corner is decided alone, and a spring ends with
/// its contact.
struct CornersWithoutTransfer : study::CornerRules {
  static constexpr bool transfers_springs = false;
};

// With these rules both codes have the same contacts. Only the order of sums differs.
TEST(LinkedLists, MoveTheWallAsTheProgramWithoutSpringTransfer) {
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

// The contact rule and the transfer of springs of runs make a difference that is small
// against the motion.
TEST(LinkedLists, MoveTheWallNearlyAsTheProgram) {
  bench::BlocksCode ours(bench::wall_of_power(2));
  bench::LinkedListCode lists(bench::wall_of_power(2));
  const Eigen::Matrix2Xd start = lists.corners();
  ours.run(300);
  lists.run(300);
  const double moved = largest_difference(start, lists.corners());
  EXPECT_LT(largest_difference(ours.model().blocks.corner, lists.corners()),
            0.05 * moved);
}

TEST(LinkedLists, ContinueFromTheSpringsOfAModel) {
  bench::BlocksCode ours(bench::wall_of_power(2));
  ours.run(2000);
  bench::LinkedListCode lists(ours.model());
  const Eigen::Matrix2Xd start = lists.corners();
  ours.run(20);
  lists.run(20);
  // Without the springs the bricks would fall freely.
  const double free_fall = 0.5 * 9.81 * std::pow(20 * ours.model().time_step.dt, 2);
  EXPECT_LT(largest_difference(ours.model().blocks.corner, lists.corners()),
            0.01 * free_fall);
}

}  // namespace
}  // namespace blocks
