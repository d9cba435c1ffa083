#include "sweep/parallel_engine.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "output/file_tools.hpp"
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

/// The numbers of the jobs that the log has as done, from 1. Its columns are Seq, Host,
/// Starttime, JobRuntime, Send, Receive, Exitval, Signal, Command. Nothing if a line is
/// damaged because GNU parallel was killed: it would refuse this log.
std::optional<std::set<std::size_t>> jobs_done(const std::string& folder) {
  std::set<std::size_t> done;
  for (const std::string& line : lines_of(log_path(folder))) {
    if (line.starts_with("Seq"))
      continue;
    std::istringstream words(line);
    std::size_t job = 0;
    std::string host, start, time, sent, received;
    int code = 0, signal = 0;
    if (!(words >> job >> host >> start >> time >> sent >> received >> code >> signal))
      return std::nullopt;
    if (code == 0 && signal == 0)
      done.insert(job);
  }
  return done;
}

/// Whether the packs of an earlier call still serve: each open run is in one of them
/// that is not done. --resume-failed needs the same list of jobs each time.
bool can_resume(const std::string& folder, const std::vector<std::size_t>& ids) {
  const auto packs = lines_of(packs_path(folder));
  const auto done = jobs_done(folder);
  if (!done)
    return false;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < packs.size(); ++i) {
    if (done->contains(i + 1))
      continue;
    const std::string& pack = packs[i];
    std::size_t first = 0, last = 0;
    const char* const end = pack.data() + pack.size();
    const auto read = std::from_chars(pack.data(), end, first);
    last = first;
    if (read.ptr != end)
      std::from_chars(read.ptr + 1, end, last);
    covered +=
        static_cast<std::size_t>(std::upper_bound(ids.begin(), ids.end(), last) -
                                 std::lower_bound(ids.begin(), ids.end(), first));
  }
  return covered == ids.size();
}

void prepare(const std::string& folder, const std::vector<std::size_t>& ids,
             std::size_t pack) {
  output::expect_no_link(fs::path(log_path(folder)).parent_path().string());
  for (const std::string& path : {log_path(folder), packs_path(folder)})
    output::expect_replaceable(path);
  if (can_resume(folder, ids))
    return;
  output::set_aside(log_path(folder));
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
  std::vector<std::string> words{"parallel",          "--will-cite",     "--joblog",
                                 log_path(folder),    "--resume-failed", "--termseq",
                                 "TERM,60000,KILL,25"};
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
