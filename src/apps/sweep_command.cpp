#include "sweep_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "apps/options/option_checks.hpp"
#include "fault.hpp"
#include "files/file_tools.hpp"
#include "files/name_lock.hpp"
#include "run/run.hpp"
#include "run/support/shell_word.hpp"
#include "sweep/slurm_engine.hpp"
#include "sweep/status.hpp"
#include "text/number.hpp"

namespace blocks::apps {
namespace {

namespace fs = std::filesystem;

/// Reads --runs 40-49. `all` is the number of runs.
sweep::Range range_of(const std::string& text, std::size_t all) {
  if (text.empty())
    return {1, all};
  const auto dash = text.find('-');
  const auto first = text::number_of<std::size_t>(text.substr(0, dash));
  const auto last = dash == std::string::npos
                        ? first
                        : text::number_of<std::size_t>(text.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first || *last > all)
    throw std::runtime_error(fmt::format(
        "--runs: expected runs from 1 to {}, such as 1-10, found '{}'", all, text));
  return {*first, *last};
}

std::string default_folder(const std::string& deck) {
  return fs::path(deck).stem().string() + ".sweep";
}

/// Locks the plan of a folder. If another sweep has begun there, waits until its plan
/// is written. Throws files::FileError, which names its process.
std::unique_ptr<files::NameLock> lock_plan(const std::string& folder) {
  using namespace std::chrono_literals;
  const std::string path = sweep::plan_path(folder);
  files::create_folder_of(path);
  for (int tries = 0;; ++tries) {
    try {
      return std::make_unique<files::NameLock>(path, path);
    } catch (const files::FileError&) {
      if (tries == 20)
        throw;
    }
    std::this_thread::sleep_for(50ms);
  }
}

/// Writes the plan of a new sweep, unless the folder has the same one already.
void write_new_plan(const std::string& folder, const sweep::Plan& plan) {
  std::error_code ignored;
  const auto lock = sweep::has_plan(folder) ? nullptr : lock_plan(folder);
  if (sweep::has_plan(folder)) {
    const std::string other = sweep::difference(sweep::read_plan(folder), plan);
    if (!other.empty())
      throw std::runtime_error(fmt::format(
          "{} is the folder of another sweep: {}\n  hint: choose another folder with "
          "-o; 'blocks sweep {}' goes on with that sweep",
          folder, other, run::shell_path(folder)));
  } else if (fs::exists(fs::path(folder) / "runs", ignored)) {
    throw std::runtime_error(fmt::format(
        "{} has runs but no sweep.json\n  hint: choose another folder with -o",
        folder));
  } else {
    sweep::write_plan(folder, plan);
  }
}

bool has_new_parameters(const SweepOptions& options) {
  const sweep::Request& request = options.request;
  return !request.seeds.empty() || !request.sets.empty() || !request.table.empty() ||
         !request.sobol.empty() || request.rows > 0 || request.until ||
         request.audit_every > 0 || options.check || options.study ||
         !request.variants.empty() || !options.output.empty();
}

int go_on(const std::string& folder, const sweep::Plan& plan,
          const SweepOptions& options) {
  const sweep::Range runs = range_of(options.runs, plan.runs.size());
  if (options.retry)
    sweep::reopen_failed_runs(folder, runs);
  return sweep::run_with_engine(folder, plan, runs, options.engine);
}

sweep::Plan plan_of(const std::string& word, const SweepOptions& options, int& code) {
  sweep::Request request = options.request;
  request.deck = word;
  if (options.study)
    return sweep::make_study_plan(request);
  request.kind = options.check ? sweep::Kind::check : sweep::Kind::run;
  return sweep::make_plan(request, code);
}

/// Refuses options that would have no effect.
void expect_used(const SweepOptions& options) {
  const sweep::EngineChoice& engine = options.engine;
  const auto expect = [](bool given, const char* option, bool used, const char* user) {
    if (given && !used)
      throw std::runtime_error(
          fmt::format("{} has no effect without {}\n  hint: remove it, or add {}",
                      option, user, user));
  };
  expect(!engine.logins.empty(), "--sshloginfile", engine.name == "parallel",
         "--engine parallel");
  expect(!engine.sbatch.empty(), "--sbatch", engine.name == "slurm", "--engine slurm");
  expect(engine.pack.has_value(), "--pack", engine.name != "local",
         "--engine parallel or --engine slurm");
  if (fs::is_directory(options.words.front()))
    return;
  expect(options.request.rows > 0, "-n", !options.request.sobol.empty(), "--sobol");
  expect(!options.request.variants.empty(), "--variants", options.study, "--study");
}

int tell_status(const std::string& folder) {
  fmt::print("{}", sweep::status_text(folder, sweep::read_plan(folder)));
  try {
    if (const std::string jobs = sweep::jobs_at_work(folder); !jobs.empty())
      fmt::print("Slurm has {}\n", jobs);
  } catch (const std::runtime_error&) {
    fmt::print("Slurm does not answer\n");
  }
  return run::done;
}

int sweep_or_throw(const SweepOptions& options) {
  const std::vector<std::string>& words = options.words;
  if (words.size() == 2 && words.front() == "status")
    return tell_status(words[1]);
  if (words.size() != 1)
    throw std::runtime_error(
        "expected a deck, the folder of a sweep, or status and a folder, found '" +
        fmt::format("{}", fmt::join(words, " ")) +
        "'\n  hint: blocks sweep --help shows what is possible");
  expect_used(options);
  const std::string& word = words.front();
  if (fs::is_directory(word)) {
    if (has_new_parameters(options))
      throw std::runtime_error(fmt::format(
          "{} is the folder of a sweep, whose parameters cannot change\n  hint: "
          "'blocks sweep {}' goes on with it; name the deck for a new sweep",
          word, run::shell_word(word)));
    const sweep::Plan plan = sweep::read_plan(word);
    sweep::expect_same_program_and_deck(word, plan);
    return go_on(word, plan, options);
  }
  int code = run::done;
  const sweep::Plan plan = plan_of(word, options, code);
  if (code != run::done)
    return code;
  const std::string folder = !options.output.empty() ? options.output
                             : options.study         ? "study.sweep"
                                                     : default_folder(word);
  write_new_plan(folder, plan);
  return go_on(folder, plan, options);
}

}  // namespace

void add_sweep_options(CLI::App& command, SweepOptions& options) {
  sweep::Request& request = options.request;
  command
      .add_option("DECK", options.words,
                  "the deck to sweep; or the folder of a sweep, to go on with it; or "
                  "status and the folder of a sweep")
      ->required();
  command
      .add_option("-o,--output", options.output,
                  "folder of a new sweep (default: NAME.sweep in this folder)")
      ->type_name("DIR");
  command.add_option("--seeds", request.seeds,
                     "seeds of the random layers, such as 1-200 or 1,5,9");
  command
      .add_option("--set", request.sets,
                  "CARD.field=value,value: run the deck with each of these values; "
                  "several --set give all combinations")
      ->allow_extra_args(false)
      ->take_all();
  command.add_option("--table", request.table,
                     "CSV with one run per line; its columns are seed or CARD.field");
  command.add_option(
      "--sobol", request.sobol,
      "CARD.field=low..high,CARD.field=low..high: runs for the first-order and total "
      "Sobol indices of up to 8 uniformly distributed parameters, which 'blocks "
      "report' computes; N (k + 2) runs for k parameters");
  command
      .add_option("-n,--rows", request.rows,
                  "number N of rows of the design of --sobol, best a power of 2")
      ->check(whole_count());
  command.add_option("--until", request.until, "end the runs at this time of the deck")
      ->check(positive_number());
  command
      .add_flag("--audit{100}", request.audit_every,
                "check the contacts by exact brute force every 100 steps or, with "
                "--audit=N, every N; a wrong decision is an unsound run")
      ->check(whole_steps());
  command.add_flag("--check", options.check,
                   "make, prove and measure the blocks, without time steps");
  command
      .add_flag("--study", options.study,
                "instead of a deck, run scenes of 'blocks study contacts': names "
                "separated by commas, or all; the seeds are the numbers of the frames")
      ->excludes("--check");
  command
      .add_option("--variants", request.variants,
                  "variants of the contact rule in a study (default: all)")
      ->delimiter(',');
  sweep::EngineChoice& engine = options.engine;
  command
      .add_option("--engine", engine.name,
                  "what starts the runs: this program (local), GNU parallel, or an "
                  "array job of Slurm; the results are the same")
      ->check(CLI::IsMember({"local", "parallel", "slurm"}))
      ->capture_default_str();
  command
      .add_option("-J,--jobs", engine.jobs,
                  "runs at once, each with one thread (default: as many as there are "
                  "processors)")
      ->check(CLI::Range(1, 100000));
  command
      .add_option("--pack", engine.pack,
                  "runs of one job of GNU parallel or one task of Slurm (default: 1, "
                  "or what the cluster needs)")
      ->check(CLI::Range(1, 1000000));
  command
      .add_option("--sshloginfile", engine.logins,
                  "machines of GNU parallel, one per line; they share this folder")
      ->check(CLI::ExistingFile);
  command.add_option("--sbatch", engine.sbatch,
                     "further options of Slurm, such as '--partition=long --time=60'");
  command.add_flag("--dry-run", engine.dry_run,
                   "write the plan, print what the engine would call, and run nothing");
  command.add_option("--runs", options.runs, "only these runs, such as 40-49");
  command
      .add_option("--time-limit", engine.run.time_limit,
                  "end a run after this many seconds; that is its outcome")
      ->check(positive_number());
  command
      .add_option("--checkpoint-every", engine.run.checkpoint_every,
                  "seconds between checkpoints of a run (default: 600)")
      ->check(positive_number());
  command.add_flag("--retry", options.retry,
                   "also go on with runs that ended with an error or a time limit");
  command.add_flag("-q,--quiet", engine.quiet, "print errors and warnings only");
}

int sweep(const SweepOptions& options) {
  try {
    return sweep_or_throw(options);
  } catch (const sweep::AxisFault& fault) {
    fmt::print(stderr, "blocks: error: {}\n  hint: {}\n", fault.what(), fault.hint);
    return run::usage_error;
  } catch (const std::runtime_error& fault) {
    return tell_fault(fault);
  }
}

}  // namespace blocks::apps
