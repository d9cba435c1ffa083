// Packs of runs, and the scripts of the engines.
#include "sweep/packs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sweep/parallel_engine.hpp"
#include "sweep/slurm_engine.hpp"

namespace blocks::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Packs, AreRangesOfOpenRuns) {
  EXPECT_THAT(packs_of({}, 3), ElementsAre());
  EXPECT_THAT(packs_of({4, 5, 6, 7}, 1), ElementsAre("4", "5", "6", "7"));
  EXPECT_THAT(packs_of({1, 2, 9, 12}, 3), ElementsAre("1-9", "12"));
}

TEST(SlurmJob, HasOneTaskPerPackAndQuotesTheFolder) {
  SlurmChoice choice;
  choice.pack = 2;
  choice.tasks_at_once = 3;
  choice.run.time_limit = 90.0;
  choice.options = {"--time=60"};
  const SlurmJob job = slurm_job("a folder", {1, 2, 3, 4, 5}, choice);
  EXPECT_THAT(job.packs, ElementsAre("1-2", "3-4", "5"));
  EXPECT_THAT(job.script, HasSubstr("#SBATCH --array=0-2%3\n"));
  EXPECT_THAT(job.script, HasSubstr("/a folder' --runs \"$runs\" -J 1 --quiet"));
  EXPECT_THAT(job.script, HasSubstr(" --time-limit 90 &\n"));
  EXPECT_THAT(job.words, testing::Contains("--time=60"));
  EXPECT_THAT(job.words.back(), testing::EndsWith("/a folder/slurm/job-1.sh"));
}

TEST(Parallel, NamesJobsAndMachines) {
  ParallelChoice choice;
  EXPECT_THAT(parallel_call("d", choice).words,
              testing::Not(testing::Contains("--jobs")));
  choice.jobs = 4;
  choice.logins = "machines";
  const std::vector<std::string> words = parallel_call("d", choice).words;
  EXPECT_THAT(words, testing::IsSupersetOf({"--jobs", "4", "--sshloginfile"}));
  EXPECT_THAT(words, testing::Contains("--joblog"));
}

}  // namespace
}  // namespace blocks::sweep
