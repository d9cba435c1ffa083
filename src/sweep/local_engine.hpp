// The engine `local`: several runs at once on this machine, each in a process of its
// own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sweep/one_run.hpp"
#include "sweep/plan.hpp"

namespace blocks::sweep {

struct LocalChoice {
  RunChoice run;
  int jobs = 1;         ///< runs at once
  std::size_t all = 0;  ///< runs that the progress line counts, finished ones included
  bool quiet = false;
};

/// What happened to the runs that the engine was given.
struct LocalResult {
  int signal = 0;                          ///< that ended the engine; 0: none
  std::size_t killed = 0;                  ///< number of runs whose process was killed
  std::size_t elsewhere = 0;               ///< number of runs that another process has
  std::optional<std::size_t> not_written;  ///< id of a run that could not write files
  std::string message;                     ///< why it could not
};

/// Runs the runs with these ids. SIGINT, SIGTERM and SIGHUP end the running ones at a
/// checkpoint; a second signal kills them. If the files of a run cannot be written, no
/// further run begins. Throws std::system_error if no process can be made.
LocalResult run_local(const std::string& folder, const Plan& plan,
                      const std::vector<std::size_t>& ids, const LocalChoice& choice);

}  // namespace blocks::sweep
