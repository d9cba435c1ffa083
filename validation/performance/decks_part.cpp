// Whole runs of the example decks: by the program, with its output, and step by step,
// to see the share of the search.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "blocks_code.hpp"
#include "child_run.hpp"
#include "parts.hpp"
#include "run/run.hpp"

namespace blocks::bench {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, removed at the end.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() / fmt::format("blocks_bench_{}", getpid())) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

struct WholeRun {
  double seconds = 0.0, block_steps = 0.0;
  long steps = 0;
};

/// threads: 1 on processor time, more on the clock, for who waits for another counts.
WholeRun run_program(const std::string& deck, bool whole, int threads) {
  const Folder folder;
  const std::string output = folder / "run";
  std::vector<std::string> words{BLOCKS_PROGRAM,          "run", deck,  "--quiet", "-j",
                                 std::to_string(threads), "-o",  output};
  if (!whole)
    words.insert(words.end(), {"--set", "MOTION.dt=0.1"});
  WholeRun run;
  const RunSeconds took = run_child(words);
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

/// The deck's steps without output. A step that searches costs a step and a search.
StepRun run_steps(const std::string& deck, long steps) {
  run::RunOptions options;
  options.deck = deck;
  options.quiet = true;
  run::CheckedDeck checked = run::build_checked(options);
  if (checked.code != run::done)
    throw std::runtime_error(deck + ": the deck has faults");
  BlocksCode code(std::move(checked.model));
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

}  // namespace

void run_decks(const Plan& plan, Report& report) {
  for (const std::string name : {"subsidence", "crater"}) {
    announce("deck of the " + name);
    const std::string deck =
        fmt::format("{}/decks/{}/{}.deck", BLOCKS_SOURCE_DIR, name, name);
    const WholeRun whole = run_program(deck, plan.whole_decks, 1);
    const StepRun loop = run_steps(deck, whole.steps);
    const double blocks = whole.block_steps / static_cast<double>(whole.steps);
    const auto cost = [&](double seconds) { return 1e9 * seconds / whole.block_steps; };
    report.rows.push_back({"decks", name + ", " + grouped(whole.steps) + " steps",
                           "blocks, whole run", 1, blocks, "block-step",
                           cost(whole.seconds)});
    report.rows.push_back({"decks", name + ", " + grouped(whole.steps) + " steps",
                           "blocks, time loop alone", 1, blocks, "block-step",
                           cost(loop.all)});
    const int threads = static_cast<int>(std::thread::hardware_concurrency());
    double together = whole.seconds;
    if (threads > 1) {
      together = run_program(deck, plan.whole_decks, threads).seconds;
      report.rows.push_back({"decks", name + ", " + grouped(whole.steps) + " steps",
                             "blocks, whole run", threads, blocks, "block-step",
                             cost(together)});
    }
    report.targets.push_back({name + ": search and list update, of the time loop",
                              100 * loop.searching / loop.all, 5, false, " %"});
    if (name == "subsidence" && plan.whole_decks)
      for (const auto& [by, seconds] : {std::pair("one thread", whole.seconds),
                                        {"all threads, on the clock", together}})
        report.targets.push_back(
            {name + ", whole run, " + by, seconds, 2, false, " s"});
  }
}

}  // namespace blocks::bench
