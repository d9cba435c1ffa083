#include "scene_targets.hpp"

#include <string>

#include "compare_codes.hpp"
#include "scenes.hpp"

namespace blocks::bench {
namespace {

/// A target against Box2D v3, which cannot be installed beside 2.4.1. Measured on the
/// same wall, v3 made `v3_over_2_4` times as many iterations per time as 2.4.1.
struct Box2dTarget {
  int power;
  double times_v3;  ///< block-steps for the cost of one body-substep of v3
  double v3_over_2_4;
};
constexpr Box2dTarget box2d_targets[] = {{3, 1.8, 3.5}, {4, 2.5, 3.3}, {5, 8.0, 11.0}};

void add_ratio_target(Report& report, const Row* row, const std::string& what,
                      double limit, bool at_least) {
  if (row != nullptr)
    report.targets.push_back({row->scene + ", " + row->state + ": " + what,
                              row->ratio->middle, limit, at_least, " times"});
}

}  // namespace

void add_pile_target(Report& report, int polygons) {
  const std::string pile = "pile, " + grouped(polygons) + " polygons";
  if (const Row* row = report.find(pile, "settling", box2d_name))
    report.targets.push_back({pile + ", settling: cost of a block-step over that of a "
                                     "body-iteration of Box2D",
                              1.0 / row->ratio->middle, 0.7, false, " times"});
}

void add_wall_targets(Report& report) {
  const std::string calm = calm_state;
  for (const Box2dTarget& one : box2d_targets) {
    const std::string scene = wall_name(one.power);
    add_ratio_target(report, report.find(scene, calm, box2d_name),
                     "cost of a body-iteration of Box2D over that of a block-step",
                     one.times_v3 * one.v3_over_2_4, true);
    add_ratio_target(report, report.find(scene, calm, linked_lists),
                     "cost of the linked lists over that of blocks", 20, true);
    const Row* deformable = report.find(scene, calm, deformable_blocks);
    add_ratio_target(report, deformable, "cost of deformable blocks over rigid ones",
                     1.5, false);
    // The report says that RIGID saves 10 % of the time.
    add_ratio_target(report, deformable, "cost of deformable blocks over rigid ones",
                     1.11, true);
  }
  const std::string ten_thousand = wall_name(4);
  if (const Row* row = report.find(ten_thousand, calm, rigid_blocks))
    report.targets.push_back(
        {ten_thousand + ", " + calm + ": a block-step", row->cost, 60, false, " ns"});
  if (const Row* row = report.find(ten_thousand, calm, rigid_blocks, 2))
    report.targets.push_back({ten_thousand + ", " + calm + ": gain by a second thread",
                              1.0 / row->ratio->middle, 1.8, true, " times"});
}

}  // namespace blocks::bench
