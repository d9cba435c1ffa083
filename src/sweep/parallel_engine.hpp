// The engine `parallel`: GNU parallel, on this machine or on several by ssh. Each of
// its jobs runs one pack of runs with the engine `local`.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sweep/one_run.hpp"

namespace blocks::sweep {

struct ParallelChoice {
  RunChoice run;
  int jobs = 0;          ///< at once, on each machine; 0: as many as it has processors
  std::size_t pack = 1;  ///< runs of one job
  std::string logins;    ///< file of --sshloginfile; empty: this machine
  bool quiet = false;
};

/// How GNU parallel is called.
struct ParallelCall {
  /// Environment variables by name: the paths of this program and of the folder.
  std::vector<std::pair<const char*, std::string>> variables;
  std::vector<std::string> words;
};

/// The packs are in DIR/parallel/packs, and the log of GNU parallel is
/// DIR/parallel/joblog; earlier logs are joblog.bak, joblog.bak2, ...
ParallelCall parallel_call(const std::string& folder, const ParallelChoice& choice);

struct ParallelEnd {
  int signal = 0;  ///< that stopped it; 0: none
  int code = 0;  ///< exit code of GNU parallel: the number of failed jobs, or an error
};

/// Runs these runs and waits for them. The progress line counts `all` runs, finished
/// ones included. SIGINT, SIGTERM and SIGHUP end the running ones at a checkpoint.
/// Throws std::system_error if GNU parallel cannot be started.
ParallelEnd run_parallel(const std::string& folder, const std::vector<std::size_t>& ids,
                         std::size_t all, const ParallelChoice& choice);

}  // namespace blocks::sweep
