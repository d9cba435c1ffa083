// Times whole runs of the example decks: by the program, with its output, and step by
// step, to measure the share of the search.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "blocks_code.hpp"
#include "child_run.hpp"
#include "deck_model.hpp"
#include "parts.hpp"
#include "temporary_folder.hpp"

namespace blocks::bench {
namespace {

struct WholeRun {
  double seconds = 0.0, block_steps = 0.0;
  long steps = 0;
};

/// Times a run. One thread is timed by processor time; several are timed by wall-clock
/// time, which includes waiting.
WholeRun run_program(const std::string& deck, bool whole, int threads) {
  const TemporaryFolder folder;
  const std::string output = folder / "run";
  std::vector<std::string> words{BLOCKS_PROGRAM,          "run", deck,  "--quiet", "-j",
                                 std::to_string(threads), "-o",  output};
  if (!whole)
    words.insert(words.end(), {"--set", "MOTION.dt=0.1"});
  WholeRun run;
  const RunCost took = run_child(words);
  run.seconds = threads > 1 ? took.clock : took.user;
  std::ifstream file(output + ".summary.json");
  const auto summary = nlohmann::json::parse(file);
  run.steps = summary.at("steps");
  run.block_steps = static_cast<double>(run.steps) * summary.at("blocks").get<double>();
  return run;
}

struct StepRun {
  double all = 0.0, searching = 0.0;  ///< seconds
};

/// Times the steps of a deck without output. A step with a search counts as the cost of
/// a step plus that of the search.
StepRun run_steps(const std::string& name, long steps) {
  BlocksCode code(deck_model(name));
  StepRun run;
  long searches = 0;
  for (long i = 0; i < steps; ++i) {
    const bool searching = code.searches();
    searches += searching ? 1 : 0;
    (searching ? run.searching : run.all) += seconds_of_run(code, 1);
  }
  const double step = run.all / static_cast<double>(steps - searches);
  run.searching -= step * static_cast<double>(searches);
  run.all += run.searching + step * static_cast<double>(searches);
  return run;
}

/// Times whole runs of decks of cut rock, whose blocks fail in several stages.
void run_rock_decks(Report& report) {
  for (const std::string name : {"footing", "slope", "opening"}) {
    announce("deck " + name);
    const WholeRun whole = run_program(deck_path(name), true, 1);
    report.rows.push_back({"decks", name + ", " + grouped(whole.steps) + " steps",
                           "blocks, whole run", 1,
                           whole.block_steps / static_cast<double>(whole.steps),
                           "block-step", 1e9 * whole.seconds / whole.block_steps});
  }
}

}  // namespace

void run_decks(const Plan& plan, Report& report) {
  run_rock_decks(report);
  for (const std::string name : {"subsidence", "crater"}) {
    announce("deck of the " + name);
    const std::string deck = deck_path(name);
    const WholeRun whole = run_program(deck, plan.whole_decks, 1);
    const StepRun loop = run_steps(name, whole.steps);
    const double blocks = whole.block_steps / static_cast<double>(whole.steps);
    const auto add_row = [&](const std::string& code, int threads, double seconds) {
      report.rows.push_back({"decks", name + ", " + grouped(whole.steps) + " steps",
                             code, threads, blocks, "block-step",
                             1e9 * seconds / whole.block_steps});
    };
    const auto add_target = [&](const std::string& by, double seconds, double limit) {
      if (name == "subsidence" && plan.whole_decks)
        report.targets.push_back(
            {name + ", whole run, " + by, seconds, limit, false, " s"});
    };
    add_row("blocks, whole run", 1, whole.seconds);
    add_row("blocks, time loop alone", 1, loop.all);
    report.targets.push_back({name + ": search and list update, of the time loop",
                              100 * loop.searching / loop.all, 5, false, " %"});
    add_target("one thread", whole.seconds, 3);
    if (std::thread::hardware_concurrency() > 1) {
      const double two = run_program(deck, plan.whole_decks, 2).seconds;
      add_row("blocks, whole run", 2, two);
      add_target("two threads, by the clock", two, 2);
    }
  }
}

}  // namespace blocks::bench
