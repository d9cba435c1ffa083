#include "sweep/parallel_engine.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include "files/file_tools.hpp"
#include "sweep/external_program.hpp"
#include "sweep/outcome.hpp"
#include "sweep/packs.hpp"
#include "sweep/plan.hpp"
#include "sweep/progress.hpp"
#include "sweep/signal_watch.hpp"

namespace blocks::sweep {
namespace {

namespace fs = std::filesystem;

std::string whole_path(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}
std::string packs_path(const std::string& folder) {
  return whole_path(folder) + "/parallel/packs";
}
std::string log_path(const std::string& folder) {
  return whole_path(folder) + "/parallel/joblog";
}

/// Makes the list of jobs. The outcomes say which runs are open, so no job of an
/// earlier call is left to GNU parallel, whose log a kill can damage.
void prepare(const std::string& folder, const std::vector<std::size_t>& ids,
             std::size_t pack) {
  files::expect_no_link(fs::path(log_path(folder)).parent_path().string());
  for (const std::string& path : {log_path(folder), packs_path(folder)})
    files::expect_replaceable(path);
  files::set_aside(log_path(folder));
  write_packs(packs_path(folder), packs_of(ids, pack));
}

// GNU parallel replaces {}, {#}, {= Perl =} and others in its command, so that the name
// of a folder could be a program. Paths are therefore passed as variables.
constexpr const char* program_variable = "BLOCKS_SWEEP_PROGRAM";
constexpr const char* folder_variable = "BLOCKS_SWEEP_FOLDER";

std::size_t count_open(const std::string& folder, const std::vector<std::size_t>& ids) {
  return static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), [&](auto id) {
    return !has_outcome(run_folder(folder, id));
  }));
}

}  // namespace

ParallelCall parallel_call(const std::string& folder, const ParallelChoice& choice) {
  std::vector<std::string> words{"parallel",       "--will-cite", "--joblog",
                                 log_path(folder), "--termseq",   "TERM,60000,KILL,25"};
  if (choice.jobs > 0)
    words.insert(words.end(), {"--jobs", fmt::format("{}", choice.jobs)});
  if (!choice.logins.empty())
    words.insert(words.end(), {"--sshloginfile", whole_path(choice.logins), "--env",
                               program_variable, "--env", folder_variable});
  std::string command =
      fmt::format("\"${}\" sweep \"${}\" --runs {{}} -J 1 --quiet --checkpoint-every "
                  "{:g}",
                  program_variable, folder_variable, choice.run.checkpoint_every);
  if (choice.run.time_limit > 0.0)
    command += fmt::format(" --time-limit {:g}", choice.run.time_limit);
  words.insert(words.end(), {"--arg-file", packs_path(folder), std::move(command)});
  return {{{program_variable, this_program()}, {folder_variable, whole_path(folder)}},
          std::move(words)};
}

ParallelEnd run_parallel(const std::string& folder, const std::vector<std::size_t>& ids,
                         std::size_t all, const ParallelChoice& choice) {
  using namespace std::chrono_literals;
  prepare(folder, ids, choice.pack);
  SignalWatch signals;
  Progress progress(all - ids.size(), all, choice.quiet);
  const ParallelCall call = parallel_call(folder, choice);
  for (const auto& [name, value] : call.variables)
    ::setenv(name, value.c_str(), 1);
  ProgramProcess parallel(call.words);
  while (!parallel.has_ended()) {
    if (signals.asked() != SignalWatch::Asked::nothing) {
      // The first signal makes it start no more jobs, the second end those at work.
      parallel.send(SIGTERM);
      std::this_thread::sleep_for(200ms);
      parallel.send(SIGTERM);
    }
    std::this_thread::sleep_for(50ms);
    if (progress.is_due())
      progress.show(all - count_open(folder, ids));
  }
  progress.clear();
  return {signals.signal(), parallel.code()};
}

}  // namespace blocks::sweep
