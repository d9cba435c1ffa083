// The code that speed is measured against computes the same as the program: a ratio of
// times means nothing between codes that compute different things.
#include <gtest/gtest.h>

#include <cmath>

#include "blocks_code.hpp"
#include "linked_list.hpp"
#include "study/variants.hpp"
#include "wall.hpp"

namespace blocks {
namespace {

double largest_difference(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

// Springs that pass from one contact to another are not of 1982. Without them every
// contact is the same in both codes, so only the order of sums differs.
TEST(LinkedLists, MoveTheWallAsTheProgramDoesWithoutHandOver) {
  Model wall = bench::wall_of_power(2);
  bench::LinkedListCode lists(wall);
  const study::Variant& ours = *study::find_variant("no-hand-over");
  dynamics::SearchBuffers buffers;
  dynamics::prepare(wall);
  const Eigen::Matrix2Xd start = wall.blocks.corner;
  for (int i = 0; i < 500; ++i) {
    if (!wall.search.current)
      ours.find(wall, buffers);
    ours.step(wall, buffers);
  }
  lists.run(500);
  EXPECT_GT(largest_difference(start, lists.corners()), 1e-5);
  EXPECT_EQ(lists.acting_contacts(), totals(wall).active_contacts);
  EXPECT_LT(largest_difference(wall.blocks.corner, lists.corners()), 1e-13);
}

// With the whole of the program's rules what differs is small against the movement.
TEST(LinkedLists, MoveTheWallNearlyAsTheProgramDoes) {
  bench::BlocksCode ours(bench::wall_of_power(2));
  bench::LinkedListCode lists(bench::wall_of_power(2));
  const Eigen::Matrix2Xd start = lists.corners();
  ours.run(300);
  lists.run(300);
  const double moved = largest_difference(start, lists.corners());
  EXPECT_LT(largest_difference(ours.model().blocks.corner, lists.corners()),
            0.01 * moved);
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
