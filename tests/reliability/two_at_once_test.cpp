// Two programs that write files of one name at the same time: one of them is refused by
// name, or one comes after the other. Nothing is lost or mixed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "post/results_reader.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string deck = preliminary() + rectangle(0, 0, 1, 1) +
                         "GRAVITY, 0, -10\nPLOTS, 0.002\nOUTPUT, 0.004\nCYCLE, 30\n";

constexpr int times = 20;

struct Pair {
  Outcome a, b;
};

/// Starts two commands in one folder at the same time.
Pair at_once(const std::string& a, const std::string& b,
             const TemporaryFolder& folder) {
  const auto command = [](const std::string& arguments, const std::string& name) {
    return "{ " BLOCKS_PROGRAM " " + arguments + " > out" + name + " 2> err" + name +
           "; echo $? > code" + name + "; } &\n";
  };
  folder.write("both.sh", command(a, "1") + command(b, "2") + "wait\n");
  EXPECT_EQ(std::system(("cd '" + folder.path().string() + "' && sh both.sh").c_str()),
            0);
  const auto outcome = [&](const std::string& name) {
    return Outcome{std::stoi(slurp(folder / ("code" + name))),
                   slurp(folder / ("out" + name)), slurp(folder / ("err" + name))};
  };
  return {outcome("1"), outcome("2")};
}

/// Requires that no temporary file and no lock is left.
void expect_tidy(const TemporaryFolder& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
    EXPECT_FALSE(name.ends_with(".lock")) << name;
  }
}

void expect_complete_run(const TemporaryFolder& folder) {
  for (const char* ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"})
    ASSERT_TRUE(folder.holds(std::string("a") + ending)) << ending;
  EXPECT_EQ(summary(folder, "a")["status"], "done");
  EXPECT_EQ(post::ResultsReader((folder / "a.vtkhdf").string()).frames(), 7);
  EXPECT_THAT(slurp(folder / "a.out"), HasSubstr("END OF RUN"));
}

TEST(TwoAtOnce, RunsOfOneNameExcludeEachOther) {
  int refused = 0;
  for (int i = 0; i < times; ++i) {
    const TemporaryFolder folder;
    folder.write("a.deck", deck);
    const auto [one, other] = at_once("run a.deck -q", "run a.deck -q", folder);
    for (const Outcome& run : {one, other})
      if (run.code != 0) {
        ++refused;
        EXPECT_EQ(run.code, 5) << run.err;
        EXPECT_THAT(run.err, HasSubstr("blocks: error: cannot write a.vtkhdf: another "
                                       "run is writing it"));
        EXPECT_THAT(run.err, HasSubstr("; use -o NAME for other files"));
      }
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    expect_complete_run(folder);
    expect_tidy(folder);
  }
  RecordProperty("refused", std::to_string(refused));
}

TEST(TwoAtOnce, RestartsOfOneRunExcludeEachOther) {
  const TemporaryFolder straight;
  straight.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q --stop-after 5", straight.path()).code, 75);
  for (int i = 0; i < times; ++i) {
    const TemporaryFolder folder;
    fs::copy(straight.path(), folder.path(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    const std::string restart = "run a.deck -q --restart a.ckpt.h5";
    const auto [one, other] = at_once(restart, restart, folder);
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    expect_complete_run(folder);
    expect_tidy(folder);
  }
}

TEST(TwoAtOnce, OtherFilesAreCompleteAfterwards) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  for (const std::string command :
       {"plot a.vtkhdf -o a.png", "export a.vtkhdf -o a.csv", "view a.vtkhdf -o a.html",
        "export a.vtkhdf -o a.geojson", "history a.vtkhdf -q ke -o ke.csv"}) {
    const std::string name = command.substr(command.rfind(' ') + 1);
    ASSERT_EQ(blocks(command, folder.path()).code, 0) << command;
    const std::string wanted = slurp(folder / name);
    for (int i = 0; i < 4; ++i) {
      const auto [one, other] = at_once(command, command, folder);
      EXPECT_EQ(one.code, 0) << command << one.err;
      EXPECT_EQ(other.code, 0) << command << other.err;
      EXPECT_TRUE(slurp(folder / name) == wanted) << command;
    }
  }
  expect_tidy(folder);
}

TEST(Lock, OfAKilledRunIsFree) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  folder.write("a.lock", "BLOCKS lock of process 1 on elsewhere\n");
  folder.write("a.vtkhdf.tmp", "BLOCKS results; HDF5 from byte 512 on.");
  EXPECT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  expect_complete_run(folder);
  expect_tidy(folder);
}

TEST(Lock, IsNotAFileOfTheUser) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  folder.write("a.lock", "combination 1234");
  const Outcome run = blocks("run a.deck -q", folder.path());
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err, "blocks: error: cannot write a.vtkhdf: a.lock is not a lock of "
                     "BLOCKS; rename it\n");
  EXPECT_EQ(slurp(folder / "a.lock"), "combination 1234");
}

// Every name that a run writes is a link to a file of the user, or to nothing.
TEST(Links, AreNeitherFollowedNorRemoved) {
  for (const std::string target : {"precious", "missing"})
    for (const char* ending :
         {".out", ".vtkhdf", ".ckpt.h5", ".ckpt.h5.prev", ".summary.json", ".lock",
          ".vtkhdf.tmp", ".ckpt.h5.tmp", ".summary.json.tmp"}) {
      const TemporaryFolder folder;
      folder.write("a.deck", deck);
      folder.write("precious", "of the user");
      const fs::path link = folder / (std::string("a") + ending);
      fs::create_symlink(target, link);
      const Outcome run = blocks("run a.deck -q", folder.path());
      const bool temporary = link.string().ends_with(".tmp");
      EXPECT_EQ(run.code, temporary ? 0 : 5) << ending << run.err;
      EXPECT_EQ(slurp(folder / "precious"), "of the user") << ending;
      EXPECT_FALSE(folder.holds("missing")) << ending;
      EXPECT_TRUE(fs::is_symlink(link)) << ending;
    }
}

TEST(Links, OfOtherCommandsAreKept) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  folder.write("precious", "of the user");
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  for (const char* target : {"precious", "missing"})
    for (const char* command :
         {"plot a.vtkhdf -o x", "export a.vtkhdf -o x", "view a.vtkhdf -o x"})
      for (const std::string ending : {".png", ".svg", ".geojson", ".csv", ".html"}) {
        fs::create_symlink(target, folder / ("x" + ending));
        EXPECT_NE(blocks(command + ending, folder.path()).code, 0) << command << ending;
        fs::remove(folder / ("x" + ending));
        fs::create_symlink(target, folder / ("x" + ending + ".tmp"));
        blocks(command + ending, folder.path());
        EXPECT_TRUE(fs::is_symlink(folder / ("x" + ending + ".tmp")));
        fs::remove(folder / ("x" + ending + ".tmp"));
        EXPECT_EQ(slurp(folder / "precious"), "of the user") << command << ending;
        EXPECT_FALSE(folder.holds("missing")) << command << ending;
        fs::remove(folder / ("x" + ending));
      }
}

// A file of the user that has a name of the run is kept for good.
TEST(OlderFiles, OfTheUserAreKept) {
  for (const std::string ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"}) {
    const TemporaryFolder folder;
    folder.write("a.deck", deck);
    folder.write("a" + ending, "of the user");
    folder.write("a" + ending + ".bak", "also of the user");
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
    EXPECT_EQ(slurp(folder / ("a" + ending + ".bak")), "also of the user");
    bool kept = false;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      kept = kept || slurp(entry.path()) == "of the user";
    EXPECT_TRUE(kept) << ending;
    EXPECT_FALSE(folder.holds("a.out.bak4")) << ending;
  }
}

}  // namespace
}  // namespace blocks::testing
