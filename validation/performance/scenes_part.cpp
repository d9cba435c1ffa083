// Times the scenes against other codes, and walls of several sizes against each other.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "blocks_code.hpp"
#include "compare_codes.hpp"
#include "parts.hpp"
#include "scene_targets.hpp"
#include "scenes.hpp"

namespace blocks::bench {
namespace {

// Other codes step at most 10^5 bricks, because more would take minutes.
constexpr int largest_compared = 5;
// Steps before the timing of the largest wall. By then chatter has begun.
constexpr long million_steps = 40;
constexpr long million_turn = 2;  // steps in a turn of the largest wall

void add_chatter_target(const std::string& scene, const Ratio& ratio, Report& report) {
  report.targets.push_back({scene + ": cost of a chattering block over a calm one",
                            ratio.middle, 2, false, " times"});
}

/// Times calm and chattering bricks in the same turns.
void compare_states(const Plan& plan, const Scene& calm, const Scene& chatter,
                    Report& report) {
  BlocksCode at_rest(advanced(calm, true)), rattling(advanced(chatter, true));
  const auto times = take_turns({&at_rest, &rattling}, plan.rounds, plan.seconds);
  add_chatter_target(calm.name, ratio(times[0], times[1]), report);
}

/// Times a wall that only the program can step in reasonable time, calm and chattering,
/// together with 10,000 bricks in the same steps.
void compare_sizes(const Plan& plan, int power, Report& report) {
  constexpr int small = 4;
  std::vector<Scene> scenes{calm_wall(small), calm_wall(power), chattering_wall(small),
                            chattering_wall(power)};
  std::vector<std::unique_ptr<BlocksCode>> codes;
  std::vector<Contestant*> turns;
  for (Scene& scene : scenes) {
    announce(scene.name + ", " + scene.state);
    codes.push_back(std::make_unique<BlocksCode>(std::move(scene.start)));
    codes.back()->run(million_steps);
    turns.push_back(codes.back().get());
  }
  const auto times = take_equal_turns(turns, plan.rounds, million_turn);
  for (const std::size_t i : {1, 3}) {
    Row row{.part = scenes[i].part,
            .scene = scenes[i].name,
            .code = codes[i]->name(),
            .blocks = codes[i]->work_per_step(),
            .unit = "block-step",
            .cost = times[i].middle(),
            .ratio = ratio(times[i - 1], times[i]),
            .against = scenes[i - 1].name,
            .state = scenes[i].state};
    const Phases share = codes[i]->run_phases(million_turn);
    row.phases = {row.cost * share.decisions, row.cost * share.forces,
                  row.cost * share.motion, row.cost * share.search};
    report.rows.push_back(row);
    report.targets.push_back({row.scene + ", " + row.state +
                                  ": cost of a block-step over that of " +
                                  grouped(std::lround(codes[0]->work_per_step())),
                              row.ratio->middle, 1.5, false, " times"});
  }
  add_chatter_target(scenes[1].name, ratio(times[1], times[3]), report);
}

}  // namespace

void run_wall(const Plan& plan, Report& report) {
  for (int power = plan.smallest; power <= std::min(plan.largest, largest_compared);
       ++power) {
    const Scene calm = calm_wall(power), chatter = chattering_wall(power);
    compare_codes(plan, calm, report);
    compare_codes(plan, chatter, report);
    compare_states(plan, calm, chatter, report);
  }
  add_wall_targets(report);
  if (plan.largest > largest_compared)
    compare_sizes(plan, largest_compared + 1, report);
}

void run_pile(const Plan& plan, Report& report) {
  compare_codes(plan, falling_pile(plan.polygons), report);
  compare_codes(plan, settling_pile(plan.polygons), report);
  compare_codes(plan, resting_pile(plan.polygons), report);
  add_pile_target(report, plan.polygons);
}

void run_slope(const Plan& plan, Report& report) {
  compare_codes(plan, slope_scene(), report);
}

void run_crater(const Plan& plan, Report& report) {
  compare_codes(plan, crater_scene(), report);
}

void run_subsidence(const Plan& plan, Report& report) {
  compare_codes(plan, subsidence_scene(), report);
}

}  // namespace blocks::bench
