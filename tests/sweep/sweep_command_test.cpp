// `blocks sweep` as a user calls it: what it makes, what it refuses, and how it goes
// on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Random blocks that fall on a fixed floor. `motion` is the time that passes.
std::string falling_blocks(const std::string& motion = "0.05") {
  return preliminary() + rectangle(-6, -2, 6, -1, true) +
         "LAYER, -6, 1, -5,0, -5,1, 5,1, 5,0, RANDOM\n"
         "GRAVITY, 0, -9.81\nFRICTN, 0.5\nPLOTS, 0.05\nMOTION, " +
         motion + "\nSTOP\n";
}

class Sweep : public ::testing::Test {
 protected:
  Sweep() { folder_.write("a.deck", falling_blocks()); }

  Outcome sweep(const std::string& words) const {
    return blocks("sweep " + words, folder_.path());
  }
  Outcome sweep_well(const std::string& words) const {
    Outcome run = sweep(words);
    EXPECT_EQ(run.code, 0) << words << run.out << run.err;
    return run;
  }
  fs::path of_run(const std::string& sweep, int id, const std::string& file) const {
    const std::string number = std::to_string(id);
    return folder_ / (sweep + "/runs/000/" + std::string(6 - number.size(), '0') +
                      number + "/" + file);
  }
  nlohmann::json json(const std::string& sweep, int id, const std::string& file) const {
    return nlohmann::json::parse(slurp(of_run(sweep, id, file)));
  }
  nlohmann::json outcome(const std::string& sweep, int id) const {
    return json(sweep, id, "outcome.json");
  }
  /// The number of times that a run has begun.
  long starts(const std::string& sweep, int id) const {
    const std::string log = slurp(of_run(sweep, id, "log.txt")),
                      mark = "blocks sweep: run";
    long count = 0;
    for (auto at = log.find(mark); at != std::string::npos; at = log.find(mark, at + 1))
      ++count;
    return count;
  }
  /// Expects that the sweep is refused with this message, a hint, and exit code 2.
  void expect_refused(const std::string& words, const std::string& message,
                      int code = 2) const {
    const Outcome run = sweep(words);
    EXPECT_EQ(run.code, code) << words;
    EXPECT_THAT(run.err, HasSubstr(message)) << words;
    EXPECT_THAT(run.err, HasSubstr("hint: ")) << words;
    EXPECT_EQ(run.out, "") << words;
  }

  TemporaryFolder folder_;
};

TEST_F(Sweep, RunsAreThoseOfBlocksRun) {
  sweep_well("a.deck --seeds 3-5 --set FRICTN.fric=.3,.6 -o s -J 2");
  ASSERT_EQ(
      blocks("run a.deck -q --seed 4 --set FRICTN.fric=.6 -o b", folder_.path()).code,
      0);
  EXPECT_EQ(json("s", 5, "a.summary.json")["state_hash"],
            summary(folder_, "b")["state_hash"]);
  EXPECT_NE(json("s", 4, "a.summary.json")["state_hash"],
            summary(folder_, "b")["state_hash"]);
  EXPECT_EQ(outcome("s", 5)["status"], "done");
  EXPECT_EQ(outcome("s", 5)["layers"]["blocks"], 6);
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("6 runs of "));
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("\n6 done\n"));
}

TEST_F(Sweep, TheSameWordsChangeNothing) {
  sweep_well("a.deck --seeds 1-4 -o s");
  const std::string plan = slurp(folder_ / "s/sweep.json");
  const auto time = fs::last_write_time(folder_ / "s/sweep.json");
  sweep_well("a.deck --seeds 1-4 -o s");
  sweep_well("s");
  EXPECT_EQ(slurp(folder_ / "s/sweep.json"), plan);
  EXPECT_EQ(fs::last_write_time(folder_ / "s/sweep.json"), time);
  for (int id = 1; id <= 4; ++id)
    EXPECT_EQ(starts("s", id), 1) << id;
}

TEST_F(Sweep, GoesOnWithWhatIsMissing) {
  sweep_well("a.deck --seeds 1-4 -o s --dry-run");
  EXPECT_THAT(sweep_well("s --runs 2-3").out, HasSubstr("2 runs: 2 done"));
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("2 done, 2 open"));
  sweep_well("s");
  for (int id = 1; id <= 4; ++id)
    EXPECT_EQ(starts("s", id), 1) << id;
}

TEST_F(Sweep, OtherWordsAreRefusedInTheFolderOfASweep) {
  sweep_well("a.deck --seeds 1-2 -o s");
  expect_refused("a.deck --seeds 1-3 -o s",
                 "another sweep: it has 2 runs instead of 3");
  expect_refused("a.deck --seeds 1-2 -o s --until 0.01", "its runs end with the deck");
  expect_refused("a.deck --seeds 1-2 -o s --check", "kind run instead of check");
  expect_refused("s --seeds 1-2", "whose parameters cannot change");
  folder_.write("a.deck", falling_blocks("0.06"));
  expect_refused("a.deck --seeds 1-2 -o s", "has changed since then");
  expect_refused("s", "has changed since then", 5);
}

TEST_F(Sweep, FaultyWordsAreRefusedBeforeAnythingIsWritten) {
  expect_refused("a.deck --seeds 5-1", "end before they begin");
  expect_refused("a.deck --seeds 1,1", "given twice");
  expect_refused("a.deck --set FRICTN.fric", "expected CARD.field=value");
  expect_refused("a.deck --set FRICTN.frik=1,2", "unknown field 'frik'", 3);
  expect_refused("a.deck --set FRICTN.fric=1,-2", "FRICTN", 3);
  expect_refused("b.deck --seeds 1-2", "cannot read b.deck", 5);
  expect_refused("a.deck --table none.csv", "cannot read none.csv", 5);
  expect_refused(". --seeds 1-2", "whose parameters cannot change");
  expect_refused(".", "it has no sweep.json", 5);
  expect_refused("status .", "it has no sweep.json", 5);
  expect_refused("- --seeds 1-2", "cannot be standard input", 5);
  folder_.write("bad.deck", "START, 1\n");
  expect_refused("bad.deck --seeds 1-2", "error: ", 3);
  EXPECT_FALSE(folder_.holds("a.sweep"));
  EXPECT_FALSE(folder_.holds("bad.sweep"));
}

TEST_F(Sweep, ASobolDesignIsRunRowByRow) {
  const std::string words =
      "a.deck --sobol FRICTN.fric=.3..0.6,STIFF.stifn=1e8..2e8 -n 2 --seeds 3 ";
  sweep_well(words + "--set FRACTION.tfrac=.05 -o s");
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("\n8 done\n"));
  const std::string log = slurp(of_run("s", 4, "log.txt"));
  EXPECT_THAT(log, HasSubstr("run 4: seed 3, FRACTION.tfrac=.05, FRICTN.fric=0."));
  expect_refused(words + "-o s", "instead of seed 3, FRICTN.fric=");
  expect_refused("a.deck -o s", "its runs are a Sobol design");
  expect_refused("a.deck --sobol FRICTN.fric=.3..0.6 -n 2 --seeds 3 -o s",
                 "its Sobol design has 2 rows, seed 3, and FRICTN.fric = 0.3 to 0.6, "
                 "STIFF.stifn = 1");
}

TEST_F(Sweep, FaultySobolDesignsAreRefused) {
  const std::string sobol = "a.deck --sobol FRICTN.fric=.3..0.6 ";
  expect_refused("a.deck --sobol FRICTN.fric=.6..0.3 -n 4", "is not below the high");
  expect_refused(sobol, "--sobol needs the number of its rows, -n");
  expect_refused(sobol + "-n 1", "one row is too few");
  expect_refused(sobol + "-n 1000000", "at most 1000000 runs");
  expect_refused(sobol + "-n 4 --seeds 1-2", "take one value each");
  expect_refused(sobol + "-n 4 --set FRICTN.fric=.5", "FRICTN.fric is given twice");
  expect_refused("a.deck -n 4", "-n has no effect without --sobol");
  expect_refused("a.deck --sobol FRICTN.frik=1..2 -n 4", "unknown field 'frik'", 3);
  // Only the low end is wrong, so a corner of the box is.
  expect_refused("a.deck --sobol FRICTN.fric=-1..1 -n 4", "FRICTN", 3);
  for (const char* rows : {"0", "-3", "1.5", "many"}) {
    const Outcome run = sweep(sobol + "-n " + rows);
    EXPECT_EQ(run.code, 2) << rows;
    EXPECT_THAT(run.err, HasSubstr("a whole number, 1 or more, found '")) << rows;
  }
  EXPECT_FALSE(folder_.holds("a.sweep"));
}

TEST_F(Sweep, AMissingEngineIsTold) {
  const std::string call =
      "PATH=/nowhere " BLOCKS_PROGRAM " sweep a.deck --seeds 1-2 -o s ";
  for (const char* engine : {"parallel", "slurm"}) {
    const std::string words = std::string("cards; cd ") + folder_.path().string() +
                              " && " + call + "--engine " + engine;
    const Outcome run = blocks(words, folder_.path());
    EXPECT_EQ(run.code, 2) << engine;
    EXPECT_THAT(run.err, HasSubstr(std::string("the engine ") + engine + " needs"));
    EXPECT_THAT(run.err, HasSubstr("or use --engine local"));
  }
}

TEST_F(Sweep, OptionsWithoutEffectAreRefused) {
  expect_refused("a.deck --pack 3", "--pack has no effect without --engine parallel");
  expect_refused("a.deck --sbatch -p", "--sbatch has no effect without --engine slurm");
  expect_refused("a.deck --variants report",
                 "--variants has no effect without --study");
}

TEST_F(Sweep, ALogThatCannotBeWrittenEndsTheSweepOnce) {
  sweep_well("a.deck --seeds 1-4 -o s --dry-run");
  fs::create_directories(of_run("s", 2, ""));
  fs::create_symlink("/dev/full", of_run("s", 2, "log.txt"));
  const Outcome run = sweep("s -J 2");
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.err, HasSubstr("run 2 could not write its files: cannot write "
                                 "s/runs/000/000002/log.txt: it is a link"));
  EXPECT_THAT(run.err, HasSubstr("hint: correct this"));
  fs::remove(of_run("s", 2, "log.txt"));
  sweep_well("s");
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("\n4 done\n"));
}

// A folder or file of the user is in the place of what the sweep makes.
TEST_F(Sweep, FilesOfTheUserStay) {
  sweep_well("a.deck --seeds 1-2 -o s --dry-run");
  fs::create_directories(folder_ / "precious");
  folder_.write("precious/a.out", "of the user");
  fs::create_directories(folder_ / "s/runs/000");
  fs::create_directory_symlink(folder_ / "precious", folder_ / "s/runs/000/000001");
  const Outcome run = sweep("s -J 1");
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.err, HasSubstr("cannot write to s/runs/000/000001: it is a link"));
  EXPECT_EQ(slurp(folder_ / "precious/a.out"), "of the user");
  EXPECT_FALSE(folder_.holds("precious/log.txt"));
  fs::remove(folder_ / "s/runs/000/000001");

  fs::create_directories(of_run("s", 1, "data"));
  folder_.write("s/runs/000/000001/notes", "of the user");
  folder_.write("s/runs/000/000001/data/notes", "of the user");
  folder_.write("s/runs/000/000001/a.out", "BLOCKS of a killed run");
  for (const char* name : {"outcome.json.tmp", "a.layers.json.tmp"})
    fs::create_symlink(folder_ / "precious/a.out", of_run("s", 1, name));
  sweep_well("s");
  EXPECT_EQ(slurp(of_run("s", 1, "notes")), "of the user");
  EXPECT_EQ(slurp(of_run("s", 1, "data/notes")), "of the user");
  EXPECT_EQ(slurp(folder_ / "precious/a.out"), "of the user");
  EXPECT_TRUE(fs::is_symlink(of_run("s", 1, "outcome.json.tmp")));
  EXPECT_FALSE(fs::exists(of_run("s", 1, "a.out.bak")));
}

TEST_F(Sweep, ADeckMayBeNamedLikeTheFilesOfASweep) {
  for (const char* name : {"log", "outcome"}) {
    folder_.write(std::string(name) + ".deck", falling_blocks());
    sweep_well(std::string(name) + ".deck --seeds 1-2 -o " + name);
    EXPECT_EQ(outcome(name, 2)["status"], "done");
    EXPECT_EQ(starts(name, 2), 1);
  }
}

TEST_F(Sweep, ADamagedOutcomeIsToldAndRunAgainByRetry) {
  sweep_well("a.deck --seeds 1-3 -o s");
  folder_.write("s/runs/000/000002/outcome.json", "{\"code\":");
  EXPECT_THAT(sweep_well("status s").out, HasSubstr("2 done, 1 damaged outcome"));
  sweep_well("s --retry");
  EXPECT_EQ(outcome("s", 2)["status"], "done");
}

TEST_F(Sweep, AFailedRunIsAnOutcome) {
  // Soft springs let the falling blocks pass into the floor.
  folder_.write("a.deck", falling_blocks("1"));
  sweep_well("a.deck --seeds 1-2 --set STIFF.stifn=1e8,1e3 -o s");
  EXPECT_EQ(outcome("s", 1)["code"], 0);
  EXPECT_EQ(outcome("s", 3)["code"], 4);
  EXPECT_EQ(outcome("s", 3)["status"], "unsound");
  EXPECT_THAT(outcome("s", 3)["message"].get<std::string>(), HasSubstr("pressed in"));
  const Outcome status = sweep_well("status s");
  EXPECT_THAT(status.out, HasSubstr("2 done, 2 unsound"));
  EXPECT_THAT(status.out,
              HasSubstr("run 3, seed 1, STIFF.stifn=1e3: unsound, exit code 4: "));
  sweep_well("s");
  EXPECT_EQ(starts("s", 3), 1);
  sweep_well("s --retry");
  EXPECT_EQ(starts("s", 3), 2);
  EXPECT_EQ(starts("s", 1), 1);
}

TEST_F(Sweep, ALimitOfTimeIsAnOutcomeThatRetryGoesOnWith) {
  folder_.write("a.deck", falling_blocks("40"));
  sweep_well("a.deck --seeds 1-2 -o s --time-limit 0.1");
  EXPECT_EQ(outcome("s", 2)["code"], 75);
  EXPECT_EQ(outcome("s", 2)["status"], "time limit");
  EXPECT_GT(json("s", 2, "a.summary.json")["steps"], 0);
  sweep_well("s --retry");
  EXPECT_EQ(outcome("s", 2)["code"], 0);
  ASSERT_EQ(blocks("run a.deck -q --seed 2 -o b", folder_.path()).code, 0);
  EXPECT_EQ(json("s", 2, "a.summary.json")["state_hash"],
            summary(folder_, "b")["state_hash"]);
}

TEST_F(Sweep, ASignalEndsTheRunsAtACheckpoint) {
  folder_.write("a.deck", falling_blocks("40"));
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string name = signal == SIGINT ? "i" : "t";
    const int code =
        killed("sweep a.deck --seeds 1-2 -J 2 -o " + name,
               name + "/runs/000/000002/a.vtkhdf", 0.2, signal, folder_.path());
    EXPECT_EQ(code, signal == SIGINT ? 130 : 75);
    EXPECT_FALSE(fs::exists(of_run(name, 2, "outcome.json")));
    EXPECT_TRUE(fs::exists(of_run(name, 2, "a.ckpt.h5")));
  }
  sweep_well("i");
  ASSERT_EQ(blocks("run a.deck -q --seed 2 -o b", folder_.path()).code, 0);
  EXPECT_EQ(json("i", 2, "a.summary.json")["state_hash"],
            summary(folder_, "b")["state_hash"]);
  EXPECT_EQ(starts("i", 2), 2);
}

// The runs of a killed sweep end at a checkpoint, meanwhile they have their folders.
TEST_F(Sweep, ASweepGoesOnRightAfterKill9) {
  folder_.write("a.deck", falling_blocks("40"));
  for (const std::string name : {"a", "b", "c"}) {
    EXPECT_EQ(killed("sweep a.deck --seeds 1-2 -J 2 -o " + name,
                     name + "/runs/000/000002/a.vtkhdf", 0.1, SIGKILL, folder_.path()),
              -1);
    EXPECT_THAT(sweep_well(name).out, Not(HasSubstr("another process")));
    EXPECT_EQ(outcome(name, 2)["status"], "done");
  }
}

TEST_F(Sweep, TwoSweepsThatBeginAtOnceShareOneFolder) {
  for (int i = 0; i < 20; ++i) {
    const std::string name = "s" + std::to_string(i),
                      words = " sweep a.deck --seeds 1-2 -o " + name;
    folder_.write("both.sh", "for i in 1 2; do " BLOCKS_PROGRAM + words +
                                 " > out$i 2>&1 || echo failed >> out$i & done; wait");
    ASSERT_EQ(
        std::system(("cd '" + folder_.path().string() + "' && sh both.sh").c_str()), 0);
    for (const char* out : {"out1", "out2"})
      EXPECT_THAT(slurp(folder_ / out), Not(HasSubstr("failed")));
    EXPECT_THAT(sweep_well("status " + name).out, HasSubstr("\n2 done\n"));
    EXPECT_EQ(starts(name, 1) + starts(name, 2), 2);
    EXPECT_FALSE(folder_.holds(name + "/sweep.json.lock"));
  }
}

TEST_F(Sweep, APlanThatAnotherProcessWritesIsNamed) {
  folder_.write("lock.py",
                "import fcntl, time, subprocess, sys\n"
                "f = open('s/sweep.json.lock', 'w')\n"
                "f.write('BLOCKS lock of process 12 on there\\n'); f.flush()\n"
                "fcntl.flock(f, fcntl.LOCK_EX)\n"
                "sys.exit(subprocess.call(['" BLOCKS_PROGRAM "', 'sweep', 'a.deck', "
                "'--seeds', '1-2', '-o', 's']))\n");
  fs::create_directory(folder_ / "s");
  const int status = std::system(
      ("cd '" + folder_.path().string() + "' && python3 lock.py 2> err").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_THAT(slurp(folder_ / "err"), HasSubstr("process 12 on there"));
}

TEST_F(Sweep, TextThatIsNotUtf8IsRefused) {
  expect_refused("a.deck --set \"$(printf 'FRICTN.fric=\\377')\"", "is not in UTF-8");
  folder_.write("table.csv", "FRICTN.fric\n\xff\n");
  expect_refused("a.deck --table table.csv", "is not in UTF-8");
}

TEST_F(Sweep, ACheckMeasuresTheSameBlocksWithoutSteps) {
  sweep_well("a.deck --seeds 1-3 -o s");
  sweep_well("a.deck --seeds 1-3 -o c --check");
  for (int id = 1; id <= 3; ++id)
    EXPECT_EQ(outcome("c", id)["layers"], outcome("s", id)["layers"]);
  EXPECT_FALSE(fs::exists(of_run("c", 1, "a.vtkhdf")));
}

TEST_F(Sweep, AStudyHasOneRunPerFrameAndScene) {
  expect_refused("stakee --study --seeds 0-3", "there is no scene 'stakee'");
  expect_refused("stake --study", "needs the numbers of its frames");
  expect_refused("stake --study --seeds 0-3 --variants defalt", "no variant 'defalt'");
  expect_refused("stake --study --seeds 0-3 --until 3", "do not apply");
  sweep_well("figure4b,stake --study --seeds 0-2 --variants default,report -o s");
  EXPECT_EQ(outcome("s", 6)["study"]["default"]["wrong_signs"], 0);
  EXPECT_TRUE(outcome("s", 1)["study"].contains("default"));
}

}  // namespace
}  // namespace blocks::testing
