#include "sweep/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "run/run.hpp"
#include "run/support/progress_line.hpp"
#include "run/support/shell_word.hpp"
#include "sweep/external_program.hpp"
#include "sweep/local_engine.hpp"
#include "sweep/parallel_engine.hpp"
#include "sweep/slurm_engine.hpp"
#include "text/counted.hpp"

namespace blocks::sweep {
namespace {

void expect_program(const std::string& engine, const std::string& program,
                    const std::string& remedy) {
  if (find_program(program).empty())
    throw std::runtime_error(fmt::format(
        "the engine {} needs the program {}, which is not here\n  hint: {}, or use "
        "--engine local",
        engine, program, remedy));
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;)
    words.push_back(word);
  return words;
}

/// Returns what to do about files that cannot be written.
std::string remedy_of(const std::string& message) {
  const auto says = [&](int reason) {
    return message.find(std::generic_category().message(reason)) != std::string::npos;
  };
  return says(ENOSPC) || says(EDQUOT) || says(EFBIG)  ? "make room"
         : says(EACCES) || says(EROFS) || says(EPERM) ? "make the folder writable"
                                                      : "correct this";
}

/// One call of an engine.
class Engine {
 public:
  Engine(const std::string& folder, const Plan& plan, const Range& runs,
         const EngineChoice& choice)
      : folder_(folder), plan_(plan), runs_(runs), choice_(choice),
        open_(open_runs(folder, runs)) {}

  int run() {
    if (choice_.name == "slurm")
      return slurm();
    if (choice_.name == "parallel")
      return parallel();
    return local();
  }

 private:
  std::size_t number_of_runs() const { return runs_.last - runs_.first + 1; }
  std::string again() const { return "blocks sweep " + run::shell_path(folder_); }

  int local() {
    if (choice_.dry_run) {
      if (!choice_.quiet)
        fmt::print("{} of {} runs are open\n", open_.size(), number_of_runs());
      return run::done;
    }
    const int processors =
        std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const LocalResult result =
        run_local(folder_, plan_, open_,
                  {choice_.run, choice_.jobs > 0 ? choice_.jobs : processors,
                   number_of_runs(), choice_.quiet});
    tell_counts();
    if (result.not_written) {
      fmt::print(
          stderr,
          "blocks: error: run {} could not write its files: {}\n  hint: {}, then "
          "give {} again\n",
          *result.not_written, result.message, remedy_of(result.message), again());
      return run::file_error;
    }
    if (result.elsewhere > 0 && !choice_.quiet)
      fmt::print("{} of the runs are at work in another process\n", result.elsewhere);
    if (result.killed > 0)
      fmt::print(stderr,
                 "blocks: warning: {} of the runs were killed, perhaps because memory "
                 "ran out\n  hint: -J 1 runs one at a time\n",
                 result.killed);
    return end(result.signal);
  }

  int parallel() {
    expect_program("parallel", "parallel",
                   "install GNU parallel (Debian's package parallel)");
    const ParallelChoice choice{choice_.run, choice_.jobs, choice_.pack.value_or(1),
                                choice_.logins, choice_.quiet};
    if (choice_.dry_run) {
      const ParallelCall call = parallel_call(folder_, choice);
      for (const auto& [name, value] : call.variables)
        fmt::print("{}={} ", name, run::shell_word(value));
      fmt::print("{}\n", shell_line(call.words));
      return run::done;
    }
    const ParallelEnd result =
        open_.empty() ? ParallelEnd{}
                      : run_parallel(folder_, open_, number_of_runs(), choice);
    tell_counts();
    if (result.code != 0 && result.signal == 0 &&
        open_runs(folder_, runs_).size() == open_.size())
      throw std::runtime_error(
          fmt::format("GNU parallel ended with code {} before any run did\n  hint: see "
                      "its message above, correct this, and give {} again",
                      result.code, again()));
    return end(result.signal);
  }

  int slurm() {
    SlurmChoice choice{choice_.run, choice_.jobs, choice_.pack.value_or(1),
                       words_in(choice_.sbatch)};
    if (choice_.dry_run) {
      if (!find_program("scontrol").empty())
        fit_packs(choice);
      if (!open_.empty()) {
        const SlurmJob job = slurm_job(folder_, open_, choice);
        fmt::print("# {}\n{}", shell_line(job.words), job.script);
      }
      return run::done;
    }
    for (const char* program : {"sbatch", "squeue", "scontrol"})
      expect_program("slurm", program, "log in to a machine of the cluster");
    if (const std::string jobs = jobs_at_work(folder_); !jobs.empty()) {
      fmt::print("still at work: {}{}\n", jobs,
                 jobs.find("held") == std::string::npos
                     ? ""
                     : "\nscontrol release JOB lets a held job go on, scancel JOB ends "
                       "it");
      return run::done;
    }
    if (open_.empty()) {
      tell_counts();
      return run::done;
    }
    fit_packs(choice);
    const std::string job = submit(folder_, slurm_job(folder_, open_, choice));
    if (!choice_.quiet)
      fmt::print(
          "job {} has {} runs, {} in a task\n'blocks sweep status {}' shows what "
          "is done\n",
          job, open_.size(), choice.pack, run::shell_path(folder_));
    return run::done;
  }

  /// Makes the packs so large that an array job holds all of them.
  void fit_packs(SlurmChoice& choice) const {
    const std::size_t max = max_tasks(), min_pack = (open_.size() + max - 1) / max;
    if (choice_.pack && *choice_.pack < min_pack)
      throw std::runtime_error(
          fmt::format("an array job of this cluster has at most {} tasks, so {} runs "
                      "need --pack {} or more\n  hint: without --pack, it is chosen",
                      max, open_.size(), min_pack));
    choice.pack = std::max(choice.pack, min_pack);
  }

  void tell_counts() const {
    if (choice_.quiet)
      return;
    const std::chrono::duration<double> spent = Clock::now() - begin_;
    fmt::print("{}: {}{}: {}\n", counted(number_of_runs(), "run"),
               words_of(count_runs(folder_, runs_)),
               open_.empty() ? "" : ", in " + run::duration(spent.count()), folder_);
  }

  /// Says what comes next. Returns the exit code.
  int end(int signal) const {
    const std::size_t open = open_runs(folder_, runs_).size();
    if (!choice_.quiet) {
      if (open == 0)
        fmt::print("blocks report {} shows the results\n", run::shell_path(folder_));
      else
        fmt::print("{} goes on with {} open runs\n", again(), open);
    }
    return open == 0          ? run::done
           : signal == SIGINT ? run::interrupted
                              : run::time_limit;
  }

  using Clock = std::chrono::steady_clock;
  const std::string& folder_;
  const Plan& plan_;
  const Range& runs_;
  const EngineChoice& choice_;
  std::vector<std::size_t> open_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

int run_with_engine(const std::string& folder, const Plan& plan, const Range& runs,
                    const EngineChoice& choice) {
  return Engine(folder, plan, runs, choice).run();
}

}  // namespace blocks::sweep
