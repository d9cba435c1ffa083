// The engine `slurm`: an array job of a cluster. Each of its tasks runs one pack of
// runs with the engine `local`.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweep/one_run.hpp"

namespace blocks::sweep {

struct SlurmChoice {
  RunChoice run;
  int tasks_at_once = 0;             ///< 0: as many as the cluster allows
  std::size_t pack = 1;              ///< runs of one task
  std::vector<std::string> options;  ///< further options of sbatch
};

/// What is submitted: a batch script and the packs of its tasks.
struct SlurmJob {
  std::vector<std::string> packs;  ///< task i of the array runs packs[i]
  std::string packs_path, script_path;
  /// At the signal TERM, which comes a minute before the limit of time, the runs stop
  /// at a checkpoint, and the task waits in the queue again.
  std::string script;
  std::vector<std::string> words;  ///< that call sbatch
};

/// Returns the next job of this sweep for these runs. Writes nothing.
SlurmJob slurm_job(const std::string& folder, const std::vector<std::size_t>& ids,
                   const SlurmChoice& choice);

/// Returns the jobs of this sweep that the cluster still has, with their states; empty
/// if there are none: "job 12: 3 RUNNING, 1 PENDING".
std::string jobs_at_work(const std::string& folder);

/// Returns the number of tasks that an array of this cluster can have.
std::size_t max_tasks();

/// Writes the script and the packs, and submits the job. Returns its number. Throws
/// std::runtime_error, with a hint, if the cluster refuses it.
std::string submit(const std::string& folder, const SlurmJob& job);

}  // namespace blocks::sweep
