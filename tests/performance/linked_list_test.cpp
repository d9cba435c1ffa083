// The reference code of the benchmark computes the same motion as the program.
// Otherwise the ratio of their times would have no meaning.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "blocks_code.hpp"
#include "dynamics/step.hpp"
#include "linked_list.hpp"
#include "wall.hpp"

namespace blocks {
namespace {

double largest_difference(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// The rules of the linked lists: each corner is decided with each near edge by (19),
/// between and (20), and a spring ends with its contact.
class ReportChecks : public dynamics::ContactRule {
 public:
  /// reach: [L] largest distance of a corner from a near edge
  explicit ReportChecks(double reach) : ContactRule({false, false}), reach_(reach) {}

  void decide(const Blocks& blocks, const dynamics::BlockParts&,
              const dynamics::PairIndex& index, int p,
              dynamics::PairScratch& scratch) const override {
    scratch.found.clear();
    const auto [low, high] = index.pairs[p];
    for (const auto& [own, other] : {std::pair(low, high), std::pair(high, low)})
      for (int c = blocks.first_corner[own]; c < blocks.first_corner[own + 1]; ++c)
        for (int e = blocks.first_corner[other]; e < blocks.first_corner[other + 1];
             ++e)
          if (acts(blocks, c, e))
            scratch.found.push_back({c, e});
  }

 private:
  bool acts(const Blocks& blocks, int corner, int edge) const {
    const auto at = [&](int k) { return Vec2(blocks.corner.col(k)); };
    const Vec2 c = at(corner), p1 = at(edge), p2 = at(blocks.next[edge]), e = p2 - p1;
    const double s = std::clamp((c - p1).dot(e) / e.squaredNorm(), 0.0, 1.0);
    return (c - p1 - s * e).norm() <= reach_ && geometry::overlap_sign(c, p1, p2) > 0 &&
           geometry::between(c, p1, p2) &&
           geometry::faces_edge(c, at(blocks.previous[corner]), p1, p2) &&
           geometry::faces_edge(c, at(blocks.next[corner]), p1, p2);
  }

  double reach_;
};

// With these rules both codes have the same contacts. Only the order of sums differs.
TEST(LinkedLists, MoveTheWallAsTheProgramWithoutSpringTransfer) {
  Model wall = bench::wall_of_power(2);
  bench::LinkedListCode lists(wall);
  dynamics::Workspace work;
  const ReportChecks rule(2.0 * wall.settings.contact_tolerance);
  work.rule = &rule;
  dynamics::prepare(wall);
  const Eigen::Matrix2Xd start = wall.blocks.corner;
  for (int i = 0; i < 500; ++i)
    dynamics::step(wall, work);
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
