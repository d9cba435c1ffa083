// Times rock that joints have cut, which is what users have.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "blocks_code.hpp"
#include "compare_codes.hpp"
#include "parts.hpp"
#include "scenes.hpp"

namespace blocks::bench {
namespace {

constexpr int calm_power = 4;  // the wall that rock is compared with

Row row_of(const Scene& scene, BlocksCode& code, const Times& times) {
  Row row{.part = scene.part,
          .scene = scene.name,
          .code = code.name(),
          .blocks = code.work_per_step(),
          .unit = "block-step",
          .cost = times.middle(),
          .state = scene.state};
  const Phases share = code.run_phases(min_profiled);
  row.phases = {row.cost * share.decisions, row.cost * share.forces,
                row.cost * share.motion, row.cost * share.search};
  return row;
}

/// Times a scene with the program only, in turns with another one.
void compare_scenes(const Plan& plan, const Scene& one, const Scene& other,
                    Report& report) {
  announce(other.name + ", " + other.state);
  BlocksCode first(advanced(one, true)), second(advanced(other, true));
  const auto times = take_turns({&first, &second}, plan.rounds, plan.seconds);
  Row row = row_of(other, second, times[1]);
  row.ratio = ratio(times[0], times[1]);
  row.against = one.name + ", " + one.state;
  report.rows.push_back(row);
}

/// Adds the targets of the rows of rock without laws, which are those so far. calm: the
/// cost of a block-step of the wall.
void add_targets(double calm, Report& report) {
  for (const Row& row : report.rows)
    if (row.part == "rock" && row.code == rigid_blocks && row.threads == 1)
      report.targets.push_back({row.scene + ", " + row.state +
                                    ": cost of a block-step over that of a calm wall",
                                row.cost / calm, 2.5, false, " times"});
}

}  // namespace

void run_rock(const Plan& plan, Report& report) {
  const int blocks = plan.largest < 5 ? 200 : 2000;
  const Cut cuts[] = {Cut::two_sets, Cut::voronoi};
  for (const Cut cut : cuts)
    for (const Support support :
         {Support::walls, Support::receding_wall, Support::one_wall})
      compare_codes(plan, rock_scene(cut, blocks, support), report);
  const Scene calm = calm_wall(std::min(calm_power, plan.largest));
  BlocksCode wall(advanced(calm, true));
  const double cost = take_turns({&wall}, plan.rounds, plan.seconds)[0].middle();
  for (const int size : {20'000, 100'000})
    for (const Cut cut : cuts)
      if (plan.largest >= 5)
        compare_scenes(plan, rock_scene(cut, blocks, Support::walls),
                       rock_scene(cut, size, Support::walls), report);
  add_targets(cost, report);
  for (const Cut cut : cuts) {
    const Scene without = rock_scene(cut, blocks, Support::walls);
    compare_scenes(plan, without, rock_with_laws(cut, blocks), report);
    const Row& row = report.rows.back();
    report.targets.push_back(
        {row.scene + ": cost with laws of joints over that without", row.ratio->middle,
         1.4, false, " times"});
  }
}

}  // namespace blocks::bench
