#include "sweep/slurm_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "files/file_tools.hpp"
#include "run/support/shell_word.hpp"
#include "sweep/external_program.hpp"
#include "sweep/packs.hpp"

namespace blocks::sweep {
namespace {

namespace fs = std::filesystem;
using run::shell_word;

/// The files of the jobs of a sweep.
std::string slurm_folder(const std::string& folder) {
  return (fs::absolute(folder) / "slurm").lexically_normal().string();
}

std::string jobs_path(const std::string& folder) {
  return slurm_folder(folder) + "/jobs";
}

/// The numbers of all jobs that were submitted.
std::vector<std::string> jobs_of(const std::string& folder) {
  return lines_of(jobs_path(folder));
}

/// The path of the files of the next job, without ending: DIR/slurm/job-3.
std::string next_name(const std::string& folder) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}/job-{}", slurm_folder(folder), number);
    if (!fs::exists(name + ".sh"))
      return name;
  }
}

/// Whether Slurm would use another folder for its logs. There is no way to write such
/// a path, so the script opens the log itself. It then lacks the messages of Slurm.
bool slurm_replaces_in(const std::string& path) {
  return path.find_first_of("%\\") != std::string::npos;
}

std::string words_of_run_choice(const RunChoice& choice) {
  std::string words = fmt::format(" --checkpoint-every {:g}", choice.checkpoint_every);
  if (choice.time_limit > 0.0)
    words += fmt::format(" --time-limit {:g}", choice.time_limit);
  return words;
}

std::string slurm_script(const std::string& folder, const std::string& packs_path,
                         std::size_t packs, const SlurmChoice& choice) {
  const std::string at_once =
      choice.tasks_at_once > 0 ? fmt::format("%{}", choice.tasks_at_once) : "";
  const std::string sweep_folder = fs::absolute(folder).lexically_normal().string();
  return fmt::format(
      R"sh(#!/bin/sh
#SBATCH --job-name=blocks
#SBATCH --array=0-{last}{at_once}
#SBATCH --ntasks=1 --cpus-per-task=1
#SBATCH --signal=B:TERM@60
#SBATCH --requeue --open-mode=append

{log}runs=$(sed -n "$((SLURM_ARRAY_TASK_ID + 1))p" {packs})
stopped=no
trap 'stopped=yes; kill -TERM $child 2>/dev/null' TERM
{program} sweep {folder} --runs "$runs" -J 1 --quiet{choice} &
child=$!
wait $child
code=$?
# A signal ends wait early; the runs are then still writing their checkpoints.
while kill -0 $child 2>/dev/null; do
  wait $child
  code=$?
done
trap '' TERM

# Runs that stopped at a checkpoint go on later: the task waits in the queue again. One
# that was cancelled is not RUNNING any more and does not come back. Runs that stopped
# without a signal were killed, or are at work in another task; they come back three times.
[ $stopped = yes ] || [ "${{SLURM_RESTART_COUNT:-0}}" -lt 3 ] || exit $code
# The number of the job alone would name the whole array.
task=${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID
tries=0
while [ $code -eq 75 ] && [ $tries -lt 60 ]; do
  if state=$(squeue --noheader --jobs="$task" --format=%T); then
    [ "$state" = RUNNING ] || break
    scontrol requeue "$task" && break
  fi
  tries=$((tries + 1))  # The controller does not answer.
  sleep 5
done
exit $code
)sh",
      fmt::arg("log", slurm_replaces_in(slurm_folder(folder))
                          ? fmt::format("exec >>{}/\"${{SLURM_ARRAY_JOB_ID}}_"
                                        "$SLURM_ARRAY_TASK_ID.log\" 2>&1\n",
                                        shell_word(slurm_folder(folder)))
                          : ""),
      fmt::arg("last", packs - 1), fmt::arg("at_once", at_once),
      fmt::arg("packs", shell_word(packs_path)),
      fmt::arg("program", shell_word(this_program())),
      fmt::arg("folder", shell_word(sweep_folder)),
      fmt::arg("choice", words_of_run_choice(choice.run)));
}

}  // namespace

SlurmJob slurm_job(const std::string& folder, const std::vector<std::size_t>& ids,
                   const SlurmChoice& choice) {
  const std::string name = next_name(folder);
  SlurmJob job;
  job.packs = packs_of(ids, choice.pack);
  job.packs_path = name + ".packs";
  job.script_path = name + ".sh";
  job.script = slurm_script(folder, job.packs_path, job.packs.size(), choice);
  job.words = {"sbatch", "--parsable",
               "--output=" + (slurm_replaces_in(slurm_folder(folder))
                                  ? "/dev/null"
                                  : slurm_folder(folder) + "/%A_%a.log")};
  job.words.insert(job.words.end(), choice.options.begin(), choice.options.end());
  job.words.push_back(job.script_path);
  return job;
}

std::string jobs_at_work(const std::string& folder) {
  const auto jobs = jobs_of(folder);
  if (jobs.empty() || find_program("squeue").empty())
    return {};
  const ProgramEnd queue =
      call_program({"squeue", "--me", "--noheader", "--array", "--format=%F %T %r"});
  if (queue.code != 0)
    throw std::runtime_error(
        "Slurm does not answer, so it is not known whether jobs of this sweep are at "
        "work\n  hint: give the same command again when squeue works");
  std::map<std::string, std::map<std::string, int>> states;  // of each job
  std::istringstream lines(queue.output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string job, state;
    words >> job >> state;
    // "launch failed requeued held" and the like need a release by hand.
    if (line.find("held") != std::string::npos)
      state += " and held";
    if (std::find(jobs.begin(), jobs.end(), job) != jobs.end())
      ++states[job][state];
  }
  std::string text;
  for (const auto& [job, numbers] : states) {
    text += fmt::format("{}job {}:", text.empty() ? "" : "; ", job);
    for (const auto& [state, number] : numbers)
      text += fmt::format("{} {} {}", text.ends_with(':') ? "" : ",", number, state);
  }
  return text;
}

std::size_t max_tasks() {
  constexpr std::size_t usual = 1000;
  const ProgramEnd config = call_program({"scontrol", "show", "config"});
  const std::string key = "MaxArraySize";
  const auto at = config.output.find(key);
  const auto number = config.output.find_first_of("0123456789", at);
  std::size_t size = 0;
  if (at == std::string::npos || number == std::string::npos)
    return usual;
  std::from_chars(config.output.data() + number,
                  config.output.data() + config.output.size(), size);
  return size > 1 ? size - 1 : usual;  // indices are below MaxArraySize
}

std::string submit(const std::string& folder, const SlurmJob& job) {
  write_packs(job.packs_path, job.packs);
  files::replace_file(job.script_path, job.script);
  const ProgramEnd end = call_program(job.words);
  if (end.code != 0)
    throw std::runtime_error(fmt::format(
        "sbatch refused the job, exit code {}\n  hint: correct the options in "
        "--sbatch, or what its message says, and give the same command again",
        end.code));
  const std::string number = end.output.substr(0, end.output.find(';'));
  files::expect_replaceable(jobs_path(folder));
  std::ofstream jobs(jobs_path(folder), std::ios::app);
  jobs << number << '\n';
  jobs.close();
  if (!jobs)
    files::throw_errno("write", jobs_path(folder));
  return number;
}

}  // namespace blocks::sweep
