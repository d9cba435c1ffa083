// Files that a sweep finds in its folder and has not written: files of the user are
// kept, links are not followed, and a FIFO or a device does not stop the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

class ForeignFiles : public ::testing::Test {
 protected:
  ForeignFiles() {
    folder_.write("a.deck", preliminary() + rectangle(-6, -2, 6, -1, true) +
                                "LAYER, -6, 1, -5,0, -5,1, 5,1, 5,0, RANDOM\n"
                                "GRAVITY, 0, -9.81\nMOTION, 0.01\nSTOP\n");
  }
  /// Makes the sweep s of one run, and the folder of this run.
  void plan_sweep() const {
    ASSERT_EQ(blocks("sweep a.deck --seeds 1-1 -o s --dry-run -q", folder_.path()).code,
              0);
    fs::create_directories(folder_ / own_);
  }
  void expect_code(int code, const std::string& words, const std::string& message) {
    const Outcome run = blocks(words, folder_.path());
    EXPECT_EQ(run.code, code) << words;
    EXPECT_THAT(run.out + run.err, HasSubstr(message)) << words;
  }
  void make_fifo(const std::string& name) const {
    fs::remove(folder_ / name);
    ASSERT_EQ(::mkfifo((folder_ / name).c_str(), 0600), 0);
  }

  const std::string own_ = "s/runs/000/000001/";
  TemporaryFolder folder_;
};

// The name of a file does not show who wrote it.
TEST_F(ForeignFiles, AreKeptWithTheExtensionBak) {
  plan_sweep();
  for (const std::string ending :
       {".out", ".vtkhdf", ".ckpt.h5", ".summary.json", ".layers.json"}) {
    fs::remove_all(folder_ / own_);
    fs::create_directories(folder_ / own_);
    const std::string text = ending.ends_with("json") ? "{\"mine\": 1}" : "mine";
    folder_.write(own_ + "a" + ending, text);
    expect_code(0, "sweep s", "1 done");
    EXPECT_EQ(slurp(folder_ / (own_ + "a" + ending + ".bak")), text);
    EXPECT_NE(slurp(folder_ / (own_ + "a" + ending)), text);
  }
}

TEST_F(ForeignFiles, OfAKilledRunAreRemoved) {
  plan_sweep();
  expect_code(0, "sweep s", "1 done");
  for (const char* name : {"outcome.json", "a.ckpt.h5"})
    fs::remove(folder_ / (own_ + name));
  expect_code(0, "sweep s", "1 done");
  for (const auto& entry : fs::directory_iterator(folder_ / own_))
    EXPECT_NE(entry.path().extension(), ".bak") << entry.path();
}

// The log is appended to, so it would change the other file.
TEST_F(ForeignFiles, TheLogIsNotALinkToAnother) {
  plan_sweep();
  folder_.write("other", "mine");
  fs::create_hard_link(folder_ / "other", folder_ / (own_ + "log.txt"));
  expect_code(5, "sweep s", "log.txt: it is a hard link");
  make_fifo(own_ + "log.txt");
  expect_code(5, "sweep s", "log.txt: it is not a regular file");
  EXPECT_EQ(slurp(folder_ / "other"), "mine");
}

TEST_F(ForeignFiles, AreNotWrittenThroughALinkToAllRuns) {
  plan_sweep();
  fs::create_directories(folder_ / "elsewhere");
  fs::remove_all(folder_ / "s/runs");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "s/runs");
  expect_code(5, "sweep s", "runs: it is a link");
}

TEST_F(ForeignFiles, OfTheEngineAreKept) {
  if (std::system("command -v parallel > /dev/null") != 0)
    GTEST_SKIP() << "GNU parallel is missing";
  plan_sweep();
  fs::create_directories(folder_ / "elsewhere");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "s/parallel");
  expect_code(5, "sweep s --engine parallel", "/s/parallel: it is a link");
  EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
  fs::remove(folder_ / "s/parallel");
  fs::create_directories(folder_ / "s/parallel");
  for (const char* name : {"packs", "joblog"})
    folder_.write(std::string("s/parallel/") + name, "mine");
  expect_code(0, "sweep s --engine parallel", "1 done");
  for (const char* name : {"packs.bak", "joblog.bak"})
    EXPECT_EQ(slurp(folder_ / (std::string("s/parallel/") + name)), "mine");
}

// A FIFO may have no writer, and a device no end.
TEST_F(ForeignFiles, ThatMayNotEndAreRefused) {
  plan_sweep();
  const std::string plan = slurp(folder_ / "s/sweep.json");
  make_fifo("fifo");
  for (const std::string& deck : {(folder_ / "fifo").string(), std::string("/dev/zero"),
                                  std::string("/dev/fd/0")}) {
    std::string forged = plan;
    const std::string before = (folder_ / "a.deck").string();
    ASSERT_NE(forged.find(before), std::string::npos);
    folder_.write("s/sweep.json",
                  forged.replace(forged.find(before), before.size(), deck));
    expect_code(5, "sweep s < /dev/zero", "cannot read " + deck + ": it is a ");
  }
  folder_.write("s/sweep.json", plan);
  make_fifo(own_ + "outcome.json");
  expect_code(0, "sweep status s", "outcome.json: it is a FIFO");
  expect_code(0, "report s", "1 failed");
  make_fifo("s/sweep.json");
  for (const char* command : {"sweep s", "sweep status s", "report s"})
    expect_code(5, command, "s/sweep.json: it is a FIFO, not a regular file");
  expect_code(5, "sweep a.deck --table fifo -o t", "fifo: it is a FIFO");
}

TEST_F(ForeignFiles, ADeckIsAFileOrAnOpenStream) {
  make_fifo("fifo");
  for (const char* command : {"check", "run", "export", "fos", "import"}) {
    expect_code(5, std::string(command) + " fifo", "cannot read fifo: it is a FIFO");
    expect_code(5, std::string(command) + " /dev/zero",
                "cannot read /dev/zero: it is a device");
  }
  for (const char* deck : {"- < a.deck", "/dev/stdin < a.deck", "/dev/fd/3 3< a.deck"})
    expect_code(0, std::string("check ") + deck, "time step");
  const std::string deck = slurp(folder_ / "a.deck");  // through a pipe
  expect_code(
      0, "--version > /dev/null; cat a.deck | '" BLOCKS_PROGRAM "' check /dev/stdin",
      "time step");
}

}  // namespace
}  // namespace blocks::testing
