// Disks that are full at the n-th change of a file, missing and read-only folders, and
// limits of file size. The program ends with exit code 5 and a message. The files of an
// earlier run stay complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::MatchesRegex;

const std::string deck = preliminary() + rectangle(0, 0, 1, 1) +
                         "GRAVITY, 0, -10\nPLOTS, 0.002\nOUTPUT, 0.004\nCYCLE, 30\n";

using Files = std::map<std::string, std::string>;

Files files_of_run(const TemporaryFolder& folder) {
  Files files;
  for (const char* name : {"a.out", "a.vtkhdf", "a.ckpt.h5", "a.summary.json"})
    files[name] = slurp(folder / name);
  return files;
}

/// Requires that the files of an earlier run exist, with their own names or as backups.
void expect_earlier(const TemporaryFolder& folder, const Files& earlier,
                    const std::string& when) {
  for (const auto& [name, bytes] : earlier) {
    bool kept = false;
    for (const char* ending : {"", ".bak", ".bak2", ".prev"})
      kept = kept ||
             (folder.holds(name + ending) && slurp(folder / (name + ending)) == bytes);
    EXPECT_TRUE(kept) << name << ", " << when;
  }
}

Outcome run_on_full_disk(const TemporaryFolder& folder, long fail_at) {
  setenv("BLOCKS_FAIL_AT", std::to_string(fail_at).c_str(), 1);
  setenv("BLOCKS_COUNT", (folder / "count").c_str(), 1);
  setenv("LD_PRELOAD", BLOCKS_FULL_DISK, 1);
  Outcome run = blocks("run a.deck -q", folder.path());
  unsetenv("LD_PRELOAD");
  return run;
}

TEST(FullDisk, IsAnErrorAndLosesNoEarlierFile) {
  const TemporaryFolder first;
  first.write("a.deck", deck);
  ASSERT_EQ(run_on_full_disk(first, 0).code, 0);
  const long changes = std::stol(slurp(first / "count"));
  ASSERT_GT(changes, 100);
  const bool all = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const long stride = all ? 1 : changes / 20, tail = all ? 0 : 12;
  long tried = 0;
  // The last changes are those of checkpoint and summary. The test tries each of them.
  for (long at = 1; at <= changes; at += at > changes - tail ? 1 : stride, ++tried) {
    const TemporaryFolder folder;
    for (const char* name :
         {"a.deck", "a.out", "a.vtkhdf", "a.ckpt.h5", "a.summary.json"})
      fs::copy_file(first / name, folder / name);
    const Files earlier = files_of_run(folder);
    const Outcome run = run_on_full_disk(folder, at);
    const std::string when = "full from change " + std::to_string(at) + " on";
    EXPECT_EQ(run.code, 5) << when << run.err;
    EXPECT_THAT(run.err, MatchesRegex("blocks: error: cannot write a\\.[a-z0-9.]+: No "
                                      "space left on device\n"))
        << when;
    expect_earlier(folder, earlier, when);
    EXPECT_EQ(run_on_full_disk(folder, 1 + at * 7 % changes).code, 5);
    expect_earlier(folder, earlier, when + ", tried again");
    for (const char* name : {"a.vtkhdf.tmp", "a.ckpt.h5.tmp", "a.summary.json.tmp"})
      EXPECT_FALSE(folder.holds(name)) << name << ", " << when;
    if (folder.holds("a.vtkhdf")) {
      EXPECT_GE(post::ResultsReader((folder / "a.vtkhdf").string()).frames(), 1)
          << when;
    }
    output::CheckpointInfo info;
    for (const char* name : {"a.ckpt.h5", "a.ckpt.h5.bak"})
      if (folder.holds(name)) {
        EXPECT_NO_THROW(output::read_checkpoint((folder / name).string(), info))
            << when;
      }
  }
  RecordProperty("tried", std::to_string(tried));
}

TEST(FileSizeLimit, IsAFileError) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{16384, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const Outcome run = blocks("run a.deck -q", folder.path());
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err, "blocks: error: cannot write a.vtkhdf: File too large\n");
}

TEST(Folder, IsNamedIfItIsAFile) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  const Outcome run = blocks("run a.deck -q -o a.deck/a", folder.path());
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err,
            "blocks: error: cannot create the folder a.deck: Not a directory\n");
  EXPECT_EQ(slurp(folder / "a.deck"), deck);
}

TEST(Folder, IsNamedIfAFileIsNeeded) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  const auto fault = [&](const std::string& output) {
    const Outcome run = blocks("run a.deck -q -o " + output, folder.path());
    EXPECT_EQ(run.code, 5);
    return run.err;
  };
  fs::create_directory(folder / "b.out");
  EXPECT_EQ(
      fault("b"),
      "blocks: error: cannot write b.out: it is a folder; give the name of a file\n");
  EXPECT_FALSE(folder.holds("b.vtkhdf") || folder.holds("b.vtkhdf.tmp"));
}

// Root may write to all folders except those of the kernel.
TEST(Folder, IsNamedIfItIsReadOnly) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  const bool root = geteuid() == 0;
  if (root && !fs::exists("/sys/kernel"))
    GTEST_SKIP() << "no folder here that is read only for root too";
  const std::string name = root ? "/sys/a" : "a";
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome run = blocks("run a.deck -q -o " + name, folder.path());
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.err, MatchesRegex("blocks: error: cannot write " + name +
                                    "\\.vtkhdf: (Permission denied|Read-only file "
                                    "system)\n"));
}

TEST(OlderFiles, OfAnotherDeckAreKeptWithAWarning) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  folder.write("b.deck", deck + "CYCLE, 5\n");
  folder.write("c.deck", deck + "CYCLE, 9\n");
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  const Files of_a = files_of_run(folder);
  EXPECT_EQ(blocks("run b.deck -q -o a", folder.path()).err,
            "warning: a.vtkhdf had results of another deck, a.deck 'A SMALL PROBLEM': "
            "the old files are kept with the extension .bak\n");
  const Files of_b = files_of_run(folder);
  EXPECT_EQ(blocks("run c.deck -q -o a", folder.path()).err,
            "warning: a.vtkhdf had results of another deck, b.deck 'A SMALL PROBLEM': "
            "the old files are kept with the extension .bak2\n");
  for (int again = 0; again < 2; ++again)
    EXPECT_EQ(blocks("run c.deck -q -o a", folder.path()).err, "");
  for (const auto& [name, bytes] : of_a)
    EXPECT_TRUE(slurp(folder / (name + ".bak")) == bytes) << name;
  for (const auto& [name, bytes] : of_b)
    EXPECT_TRUE(slurp(folder / (name + ".bak2")) == bytes) << name;
}

// The versions differ by text or by options.
TEST(OlderFiles, OfAnEarlierVersionOfTheDeckAreKeptWithAWarning) {
  const TemporaryFolder folder;
  std::vector<Files> versions;
  for (const char* cycles : {"CYCLE, 30", "CYCLE, 31", "CYCLE, 32"}) {
    std::string text = deck;
    text.replace(text.find("CYCLE, 30"), 9, cycles);
    folder.write("a.deck", text);
    const Outcome run = blocks("run a.deck -q", folder.path());
    EXPECT_EQ(run.code, 0);
    versions.push_back(files_of_run(folder));
    EXPECT_EQ(run.err.empty(), versions.size() == 1);
  }
  EXPECT_EQ(blocks("run a.deck -q --set CYCLE.ncycle=9", folder.path()).err,
            "warning: a.vtkhdf had results of this deck with other text, options or "
            "seed: the old files are kept with the extension .bak3\n");
  for (std::size_t i = 0; i < versions.size(); ++i)
    for (const auto& [name, bytes] : versions[i])
      EXPECT_TRUE(slurp(folder / (name + (i == 0   ? ".bak"
                                          : i == 1 ? ".bak2"
                                                   : ".bak3"))) == bytes)
          << name << i;
}

}  // namespace
}  // namespace blocks::testing
