// One run of a sweep, in its folder and in this process.
#pragma once

#include <cstddef>
#include <string>

#include "sweep/plan.hpp"

namespace blocks::sweep {

/// Options of a command that starts or continues a sweep.
struct RunChoice {
  double time_limit = 0.0;          ///< wall-clock seconds of a run; 0: none
  double checkpoint_every = 600.0;  ///< wall-clock seconds
};

/// How run_once ended.
struct RunEnd {
  enum class What {
    finished,     ///< the run has an outcome
    interrupted,  ///< it goes on later
    not_written,  ///< its files could not be written; it goes on later
    elsewhere     ///< another process runs it, or has just finished it
  };
  What what = What::finished;
  int code = 0;              ///< of the outcome
  std::string message = {};  ///< the first error; empty if there was none
};

/// Runs the run with this id of the plan in `folder`, from its checkpoint if it has
/// one, and writes its outcome. Meanwhile this process holds the lock on the log of the
/// run, so no run is run twice at a time. Standard output and error of this process
/// become that log. Uses one thread. Call it in a process of its own.
RunEnd run_once(const std::string& folder, const Plan& plan, std::size_t id,
                const RunChoice& choice);

/// Writes the outcome of a run whose process was killed by a signal.
void write_crash(const std::string& folder, std::size_t id, int signal);

}  // namespace blocks::sweep
