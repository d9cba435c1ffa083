// Two programs that write files of one name at the same time: one of them is refused by
// name, or one comes after the other. Nothing is lost or mixed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string deck = preliminary() + rectangle(0, 0, 1, 1) +
                         "GRAVITY, 0, -10\nPLOTS, 0.002\nOUTPUT, 0.004\nCYCLE, 30\n";

/// How often a test starts a pair; far more often in the long version.
int times(int usual) {
  return std::getenv("BLOCKS_THOROUGH") != nullptr ? 25 * usual : usual;
}

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
  for (int i = 0; i < times(20); ++i) {
    const TemporaryFolder folder;
    folder.write("a.deck", deck);
    const auto [one, other] = at_once("run a.deck -q", "run a.deck -q", folder);
    for (const Outcome& run : {one, other})
      if (run.code != 0) {
        ++refused;
        EXPECT_EQ(run.code, 5) << run.err;
        EXPECT_THAT(run.err, HasSubstr("blocks: error: cannot write a.vtkhdf: another "
                                       "program is writing it"));
        EXPECT_THAT(run.err, HasSubstr("; use -o NAME for other files"));
      }
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    expect_complete_run(folder);
    expect_tidy(folder);
  }
  RecordProperty("refused", std::to_string(refused));
  RecordProperty("pairs", std::to_string(times(20)));
}

TEST(TwoAtOnce, RestartsOfOneRunExcludeEachOther) {
  const TemporaryFolder straight;
  straight.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q --stop-after 5", straight.path()).code, 75);
  for (int i = 0; i < times(20); ++i) {
    const TemporaryFolder folder;
    fs::copy(straight.path(), folder.path(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    // A new run and a restart of the old one exclude each other, too.
    const std::string restart = "run a.deck -q --restart a.ckpt.h5";
    const auto [one, other] =
        at_once(restart, i % 2 == 0 ? restart : "run a.deck -q", folder);
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    for (const Outcome& run : {one, other})
      EXPECT_TRUE(run.code == 0 || run.code == 5) << run.err;
    expect_complete_run(folder);
    expect_tidy(folder);
  }
  RecordProperty("pairs", std::to_string(times(20)));
}

/// Returns the contents of the files of a folder whose names begin like this.
std::map<std::string, std::string> files_like(const TemporaryFolder& folder,
                                              const std::string& name) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    const std::string path = fs::relative(entry.path(), folder.path()).string();
    if (entry.is_regular_file() && path.starts_with(name))
      found[path] = slurp(entry.path());
  }
  return found;
}

TEST(TwoAtOnce, OtherFilesAreCompleteAfterwards) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  ASSERT_EQ(blocks("sweep a.deck -q --seeds 1-3 -o s", folder.path()).code, 0);
  const char* const commands[] = {"plot a.vtkhdf -o x.png",
                                  "view a.vtkhdf -o x.html",
                                  "check a.deck -q --geometry --plot x.png",
                                  "export a.vtkhdf -o x.csv",
                                  "export a.vtkhdf -o x.geojson",
                                  "history a.vtkhdf -q kinetic_energy -o x.csv",
                                  "report s -o x.html,x.csv,x.json --run-table xt.csv"};
  int pairs = 0;
  for (const std::string command : commands) {
    if (blocks(command, folder.path()).code != 0) {
      ADD_FAILURE() << command;
      continue;
    }
    const auto wanted = files_like(folder, "x");
    for (int i = 0; i < times(4); ++i, ++pairs) {
      const auto [one, other] = at_once(command, command, folder);
      EXPECT_EQ(one.code, 0) << command << one.err;
      EXPECT_EQ(other.code, 0) << command << other.err;
      for (const auto& [path, content] : wanted)
        EXPECT_TRUE(slurp(folder / path) == content) << command << ": " << path;
    }
    for (const auto& [path, content] : files_like(folder, "x"))
      fs::remove(folder / path);
  }
  expect_tidy(folder);
  RecordProperty("pairs", std::to_string(pairs));
}

// These write many files into one folder, so one of them is refused.
TEST(TwoAtOnce, ExportsOfASeriesExcludeEachOther) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  const std::string first = "export a.vtkhdf -o x.pvd -t 0",
                    all = "export a.vtkhdf -o x.pvd";
  ASSERT_EQ(blocks(first, folder.path()).code, 0);
  const auto of_first = files_like(folder, "x");
  for (const auto& [path, content] : of_first)
    fs::remove(folder / path);
  fs::remove(folder / "x_vtu");
  ASSERT_EQ(blocks(all, folder.path()).code, 0);
  const auto of_all = files_like(folder, "x");
  int refused = 0;
  for (int i = 0; i < times(8); ++i) {
    const auto [one, other] = at_once(all, i % 2 == 0 ? all : first, folder);
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    for (const Outcome& series : {one, other})
      if (series.code != 0) {
        ++refused;
        EXPECT_EQ(series.code, 5) << series.err;
        EXPECT_THAT(series.err, HasSubstr("blocks: error: cannot write x.pvd: another "
                                          "program is writing it"));
      }
    auto left = files_like(folder, "x");
    std::erase_if(left, [](const auto& file) {
      return file.first.find(".bak") != std::string::npos;
    });
    EXPECT_TRUE(left == of_all || left == of_first) << i;
  }
  expect_tidy(folder);
  RecordProperty("refused", std::to_string(refused));
}

// Which of the two files remains is not determined, but it is one of them.
TEST(TwoAtOnce, DifferentCommandsLeaveTheFileOfOneOfThem) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  const std::string plot = "plot a.vtkhdf -o x.svg",
                    history = "history a.vtkhdf -q kinetic_energy -o x.svg";
  ASSERT_EQ(blocks(plot, folder.path()).code, 0);
  const std::string blocks_drawn = slurp(folder / "x.svg");
  ASSERT_EQ(blocks(history, folder.path()).code, 0);
  const std::string curve = slurp(folder / "x.svg");
  for (int i = 0; i < times(8); ++i) {
    const auto [one, other] = at_once(plot, history, folder);
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(other.code, 0) << other.err;
    const std::string left = slurp(folder / "x.svg");
    EXPECT_TRUE(left == blocks_drawn || left == curve);
  }
  expect_tidy(folder);
  RecordProperty("pairs", std::to_string(times(8)));
}

TEST(TwoAtOnce, SweepsOfOneFolderShareItsRuns) {
  for (int i = 0; i < times(6); ++i) {
    const TemporaryFolder folder;
    folder.write("a.deck", deck);
    const std::string sweep = "sweep a.deck -q --seeds 1-4 -o s";
    const auto [one, other] = at_once(sweep, sweep, folder);
    EXPECT_TRUE(one.code == 0 || other.code == 0) << one.err << other.err;
    // A run may be at work elsewhere when one of them ends.
    EXPECT_EQ(blocks("sweep s -q", folder.path()).code, 0);
    for (const char* run : {"1", "2", "3", "4"}) {
      const fs::path place = fs::path("s/runs/000") / (std::string("00000") + run);
      const auto outcome =
          nlohmann::json::parse(slurp(folder / (place / "outcome.json").string()));
      EXPECT_EQ(outcome["code"], 0) << run;
      EXPECT_EQ(post::ResultsReader((folder / (place / "a.vtkhdf").string()).string())
                    .frames(),
                7);
    }
  }
  RecordProperty("pairs", std::to_string(times(6)));
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
