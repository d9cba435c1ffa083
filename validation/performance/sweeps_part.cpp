// Times what a sweep costs beside its runs, and its plan and report.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "child_run.hpp"
#include "parts.hpp"
#include "temporary_folder.hpp"

namespace blocks::bench {
namespace {

namespace fs = std::filesystem;

const char* const short_deck = BLOCKS_SOURCE_DIR "/validation/performance/short.deck";
const char* const layer_deck = BLOCKS_SOURCE_DIR "/validation/geometry/layer.deck";

std::string seeds(long count) { return fmt::format("1-{}", count); }

/// Returns the seconds that the runs in a folder took by themselves: to build the
/// blocks, to make the steps, and to write the files.
double own_seconds(const std::string& folder) {
  double sum = 0.0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().string().ends_with(".summary.json")) {
      std::ifstream file(entry.path());
      sum += nlohmann::json::parse(file).at("wall_seconds").get<double>();
    }
  return sum;
}

/// Seconds for each run by the clock.
struct Overhead {
  double all = 0.0;   ///< of the program or programs
  double more = 0.0;  ///< without what the runs took by themselves
};

Overhead overhead_of_sweep(long runs) {
  const TemporaryFolder folder;
  const double clock = run_child({BLOCKS_PROGRAM, "sweep", short_deck, "--seeds",
                                  seeds(runs), "-J", "1", "-q", "-o", folder / "sweep"})
                           .clock;
  const auto count = static_cast<double>(runs);
  return {clock / count, (clock - own_seconds(folder / "sweep")) / count};
}

Overhead overhead_of_run(long runs) {
  const TemporaryFolder folder;
  double clock = 0.0;
  for (long i = 1; i <= runs; ++i)
    clock +=
        run_child({BLOCKS_PROGRAM, "run", short_deck, "--seed", std::to_string(i), "-q",
                   "-j", "1", "-o", folder / fmt::format("runs/{}/short", i)})
            .clock;
  const auto count = static_cast<double>(runs);
  return {clock / count, (clock - own_seconds(folder / "runs")) / count};
}

void time_overhead(const Plan& plan, Report& report) {
  const long runs = plan.whole_decks ? 200 : 20;
  announce(fmt::format("sweeps, {} short runs", runs));
  std::vector<double> all[2], more[2];
  for (int round = 0; round < plan.rounds; ++round) {
    const Overhead costs[2] = {overhead_of_run(runs), overhead_of_sweep(runs)};
    for (int k = 0; k < 2; ++k) {
      all[k].push_back(costs[k].all);
      more[k].push_back(costs[k].more);
    }
  }
  const std::string scene = grouped(runs) + " runs of 100 steps";
  const char* const names[2] = {"blocks run", "blocks sweep"};
  for (int k = 0; k < 2; ++k) {
    report.rows.push_back({"sweeps", scene, fmt::format("{}, by the clock", names[k]),
                           1, 6, "run", 1e9 * median(all[k])});
    report.rows.push_back({"sweeps", scene,
                           fmt::format("{}, beside the run itself", names[k]), 1, 6,
                           "run", 1e9 * median(more[k])});
  }
  report.targets.push_back({"a run of a sweep, beside the run itself",
                            1e3 * median(more[1]), 20, false, " ms"});
}

void time_plan(const Plan& plan, Report& report) {
  const long runs = plan.whole_decks ? 100000 : 1000;
  announce(fmt::format("sweeps, the plan of {} runs", grouped(runs)));
  const TemporaryFolder folder;
  const RunCost planned =
      run_child({BLOCKS_PROGRAM, "sweep", short_deck, "--seeds", seeds(runs),
                 "--dry-run", "-q", "-o", folder / "sweep"});
  const RunCost status =
      run_child({BLOCKS_PROGRAM, "sweep", "status", folder / "sweep"});
  const std::string name = grouped(runs) + " runs";
  for (const auto& [what, cost] : {std::pair{"plan", planned}, {"status", status}}) {
    report.rows.push_back({"sweeps", name, what, 1, 6, "run",
                           1e9 * cost.clock / static_cast<double>(runs)});
    if (!plan.whole_decks)
      continue;
    report.targets.push_back(
        {fmt::format("{} of {}", what, name), cost.clock, 5, false, " s"});
    report.targets.push_back({fmt::format("{} of {}, memory", what, name),
                              1e-6 * cost.memory, 200, false, " MB"});
  }
}

void time_layers(const Plan& plan, Report& report) {
  const long layers = plan.whole_decks ? 10000 : 100;
  announce(fmt::format("sweeps, {} layers and their report", grouped(layers)));
  const TemporaryFolder folder;
  const RunCost sweep =
      run_child({BLOCKS_PROGRAM, "sweep", layer_deck, "--check", "--seeds",
                 seeds(layers), "-J", "1", "-q", "-o", folder / "sweep"});
  const RunCost page =
      run_child({BLOCKS_PROGRAM, "report", folder / "sweep", "--quiet"});
  const std::string name = grouped(layers) + " layers of 100 blocks";
  double all = 0.0;
  for (const auto& [what, cost] : {std::pair{"swept", sweep}, {"report", page}}) {
    const double seconds = cost.user + cost.system;
    all += seconds;
    report.rows.push_back({"sweeps", name, what, 1, 100, "layer",
                           1e9 * seconds / static_cast<double>(layers)});
  }
  if (!plan.whole_decks)
    return;
  report.targets.push_back({name + " with their report", all, 60, false, " s"});
  report.targets.push_back(
      {name + ", memory of the report", 1e-6 * page.memory, 200, false, " MB"});
}

}  // namespace

void run_sweeps(const Plan& plan, Report& report) {
  time_overhead(plan, report);
  time_plan(plan, report);
  time_layers(plan, report);
}

}  // namespace blocks::bench
