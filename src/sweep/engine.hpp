// The engines that run a sweep: local, parallel and slurm.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sweep/one_run.hpp"
#include "sweep/plan.hpp"
#include "sweep/status.hpp"

namespace blocks::sweep {

struct EngineChoice {
  std::string name = "local";  ///< local, parallel or slurm
  RunChoice run;
  int jobs = 0;  ///< runs at once; 0: as many as there are processors or nodes
  /// Runs of one job of GNU parallel or one task of Slurm; empty: one, or as many as an
  /// array job needs to hold all.
  std::optional<std::size_t> pack;
  std::string logins;    ///< file of --sshloginfile; empty: this machine
  std::string sbatch;    ///< further options of sbatch, separated by blanks
  bool dry_run = false;  ///< only prints what would be called
  bool quiet = false;
};

/// Runs those of these runs that have no outcome, and says at the end how the sweep
/// stands. Returns the exit code: run::done if all of them have an outcome or have been
/// submitted. Throws std::runtime_error, with a hint, if the engine is missing.
int run_with_engine(const std::string& folder, const Plan& plan, const Range& runs,
                    const EngineChoice& choice);

}  // namespace blocks::sweep
