// `blocks report` on sweeps that were really run: the same tables however the runs were
// made, failed runs are rows, and sweeps that do not belong together are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <sstream>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Random blocks in a layer above a gap, with the friction as a parameter.
const std::string layer = "START, 40, 4\nA LAYER <OVER> A GAP\n"
                          "XLIMITS, -20, 20\nYLIMITS, -20, 20\nBOXES, 10, 10, 0.1\n"
                          "STIFF, 1.E7, 1.E7\nFRACTION, 0.02\n"
                          "MATERIAL, 1, 1.E9, 4.E8, 1000\nUNITS, m, kg, s\nRIGID\nEND\n"
                          "CREATE, 4, 1, 1\n-6, -6, -2, -2\n-1, 0, 0, -1\n"
                          "CREATE, 4, 1, 1\n2, 2, 6, 6\n-1, 0, 0, -1\n"
                          "LAYER, -10, 1, -5,0, -5,1, 5,1, 5,0, RANDOM\n"
                          "GRAVITY, 0, -10\nFRICTN, 0.5\nPLOTS, 0.02\n"
                          "HISTORY, 0.01, dy:min, kinetic_energy\nMOTION, 0.1\n";

class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("layer.deck", layer);
    sweep("layer.deck --seeds 1-4 --set FRICTN.fric=.2,.6 -o one");
  }
  void sweep(const std::string& words) {
    const Outcome run = blocks("sweep " + words, folder_.path());
    ASSERT_EQ(run.code, 0) << run.err << run.out;
  }
  Outcome report(const std::string& words) {
    return blocks("report " + words, folder_.path());
  }
  std::string text(const std::string& file) { return slurp(folder_ / file); }
  std::string run_folder(const std::string& sweep, int id) {
    return sweep + "/runs/000/00000" + std::to_string(id);
  }
  void set_outcome(int id, const std::string& json) {
    folder_.write(run_folder("one", id) + "/outcome.json", json);
  }
  TemporaryFolder folder_;
};

/// Returns the lines of a text that begin so.
std::vector<std::string> lines_of(const std::string& text, const std::string& begin) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(begin))
      found.push_back(line);
  return found;
}

TEST_F(Report, TablesAreTheSameForEveryOrderOfTheRuns) {
  ASSERT_EQ(report("one -o one.csv,one.json --run-table runs.csv").code, 0);
  // In another folder, one after the other, the last runs first.
  sweep("layer.deck --seeds 1-4 --set FRICTN.fric=.2,.6 --runs 5-8 -J 1 -o b/other");
  sweep("b/other -J 1");
  ASSERT_EQ(report("b/other -o other.csv,other.json --run-table others.csv").code, 0);
  EXPECT_EQ(text("one.csv"), text("other.csv"));
  EXPECT_EQ(text("one.json"), text("other.json"));
  EXPECT_EQ(text("runs.csv"), text("others.csv"));
  EXPECT_EQ(lines_of(text("one.csv"), ".2,quantity").size(), 3U)
      << "the profile, and what HISTORY recorded";
  EXPECT_THAT(text("one.json"), Not(HasSubstr(folder_.path().string())));
}

TEST_F(Report, AValueIsThatOfBlocksHistory) {
  ASSERT_EQ(report("one -q 'dy:min,dy:min@0.055,speed:max@max,y:5' --run-table "
                   "runs.csv -o one.csv")
                .code,
            0);
  const std::string row = lines_of(text("runs.csv"), "3,.2,3,done,0,done,,").front();
  const auto history = [&](const std::string& words) {
    const auto lines = lines_of(
        blocks("history " + run_folder("one", 3) + "/layer.vtkhdf --csv " + words,
               folder_.path())
            .out,
        "0.");
    std::vector<double> values;
    for (const std::string& line : lines)
      values.push_back(std::stod(line.substr(line.find(',') + 1)));
    return values;
  };
  std::vector<double> values;
  std::istringstream cells(row.substr(std::string("3,.2,3,done,0,done,,").size()));
  for (std::string cell; std::getline(cells, cell, ',');)
    values.push_back(std::stod(cell));
  ASSERT_EQ(values.size(), 4U) << row;
  const auto samples = history("-q dy:min");  // from time 0.01
  EXPECT_EQ(values[0], samples.back());
  EXPECT_NEAR(values[1], 0.5 * (samples[4] + samples[5]), 1e-6 * std::abs(values[1]));
  const auto speed = history("-q speed:max --frames");
  EXPECT_EQ(values[2], *std::max_element(speed.begin(), speed.end()));
  EXPECT_EQ(values[3], history("-q y:5 --frames").back());
}

TEST_F(Report, FailedRunsAreRowsAndSharesAndNotInTheMeans) {
  set_outcome(1,
              R"({"code": 4, "status": "unsound", "message": "block 3, \"upset\""})");
  set_outcome(2, R"({"code": 75, "status": "time limit", "message": ""})");
  fs::remove(folder_ / run_folder("one", 3) / "outcome.json");
  const Outcome run = report("one --run-table runs.csv -o one.csv");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string rows = text("runs.csv"), table = text("one.csv");
  EXPECT_THAT(rows,
              HasSubstr("\n1,.2,1,unsound,4,unsound,\"block 3, \"\"upset\"\"\","));
  EXPECT_THAT(rows, HasSubstr("\n2,.2,2,time limit,75,time limit,,"));
  EXPECT_THAT(rows, HasSubstr("\n3,.2,3,not finished,,not finished,,,,\n"));
  EXPECT_THAT(table, HasSubstr("\n.2,outcome,unsound,,3,,1,0.333333333333333"));
  EXPECT_THAT(table, HasSubstr("\n.2,outcome,not finished,,,,1,"));
  EXPECT_THAT(table, HasSubstr("\n.2,quantity,dy:min,m,1,0,,"));
  EXPECT_THAT(run.out, HasSubstr("1 done, 1 unsound, 1 time limit, 1 not finished"));
}

TEST_F(Report, ThePageNeedsNothingElseAndLinksToEveryRun) {
  ASSERT_EQ(report("one --pages 3").code, 0);
  const std::string page = text("one/report.html");
  EXPECT_THAT(page, HasSubstr("<h1>A LAYER &lt;OVER&gt; A GAP</h1>"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  int played = 0;
  for (int id = 1; id <= 8; ++id) {
    const std::string link = "runs/000/00000" + std::to_string(id) + "/layer.html";
    EXPECT_THAT(page, HasSubstr("href=\"" + link + "\""));
    ASSERT_TRUE(folder_.holds("one/" + link));
    played += text("one/" + link).find("id=\"data\"") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(played, 2) << "the median run of each group; no room for both extremes";
}

TEST_F(Report, EachFigureHasAFileOfItsOwn) {
  ASSERT_EQ(report("one -q dy:min -o f.svg,f.pdf --size 85mm").code, 0);
  for (const char* name :
       {"profile", "histogram-dy-min", "mean-dy-min", "difference-dy-min"}) {
    EXPECT_TRUE(text(std::string("f-") + name + ".svg").starts_with("<?xml")) << name;
    EXPECT_TRUE(text(std::string("f-") + name + ".pdf").starts_with("%PDF")) << name;
  }
}

TEST_F(Report, APageIsWrittenAgainOnlyIfItIsOlderOrHasOtherOptions) {
  ASSERT_EQ(report("one").code, 0);
  const std::string page = run_folder("one", 1) + "/layer.html";
  const std::string mine = text(page) + "mine";
  folder_.write(page, mine);
  ASSERT_EQ(report("one").code, 0);
  EXPECT_EQ(text(page), mine);
  for (const char* options : {"one --mirror 0", "one --units mm,kg,s", "one"}) {
    folder_.write(page, text(page) + "mine");
    ASSERT_EQ(report(options).code, 0);
    EXPECT_FALSE(text(page).ends_with("mine")) << options;
  }
  folder_.write(page, mine);
  fs::last_write_time(folder_ / page,
                      fs::last_write_time(folder_ / page) - std::chrono::hours(1));
  ASSERT_EQ(report("one").code, 0);
  EXPECT_FALSE(text(page).ends_with("mine"));
}

TEST_F(Report, DamagedMissingAndForeignFilesMakeFailedRows) {
  set_outcome(1, R"({"code": 0, "sta)");
  fs::remove(folder_ / run_folder("one", 2) / "layer.vtkhdf");
  fs::copy_file(folder_ / run_folder("one", 4) / "layer.vtkhdf",
                folder_ / run_folder("one", 3) / "layer.vtkhdf",
                fs::copy_options::overwrite_existing);
  const Outcome run =
      report("one -q dy:min,p21 --run-table runs.csv -o one.csv,one.html");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string rows = text("runs.csv");
  EXPECT_THAT(rows, HasSubstr("\n1,.2,1,failed,,damaged outcome,\"outcome.json is "
                              "damaged: it has no JSON object with \"\"code\"\"; "
                              "remove it"));
  EXPECT_THAT(rows, HasSubstr("\n2,.2,2,failed,0,results missing,layer.vtkhdf is "
                              "missing,,"));
  EXPECT_THAT(rows, HasSubstr("\n3,.2,3,failed,0,results of another run,\"layer.vtkhdf "
                              "is of a run with seed 4, not 3\",,"));
  EXPECT_THAT(text("one.csv"), HasSubstr("\n.2,quantity,dy:min,m,1,0,,"));
  // Measures of the generated blocks do not need the results.
  ASSERT_EQ(report("one -q p21 -o one.csv").code, 0);
  EXPECT_THAT(text("one.csv"), HasSubstr("\n.2,quantity,p21,1/m,3,0,,"));
}

TEST_F(Report, UnitsAreKnownIfNoRunIsDone) {
  for (int id = 1; id <= 8; ++id)
    set_outcome(id, R"({"code": 75, "status": "time limit", "message": ""})");
  ASSERT_EQ(report("one -q dy:min -o one.csv").code, 0);
  EXPECT_THAT(text("one.csv"), HasSubstr("\n.2,quantity,dy:min,m,0,0,"));
}

TEST_F(Report, PicturesOfTypicalRunsNameTheMedianAndTheGroups) {
  ASSERT_EQ(report("one -q dy:min -o one.csv,one.html").code, 0);
  const std::string page = text("one.html");
  EXPECT_THAT(page, HasSubstr("<h2>Typical runs</h2>\n<p>The pictures show a run with "
                              "FRICTN.fric = .2 and a run with FRICTN.fric = .6.</p>"));
  EXPECT_THAT(page, ::testing::ContainsRegex("displacement y at the end of [^ ]* m is "
                                             "nearest to the median, [^ ]* m, of the 4 "
                                             "runs\\."));
}

TEST_F(Report, TwoDecksAreComparedBySeed) {
  std::string other = layer;
  other.replace(other.find("GRAVITY, 0, -10"), 15, "GRAVITY, 0, -20");
  folder_.write("heavy.deck", other);
  sweep("heavy.deck --seeds 2-5 --set FRICTN.fric=.2 -o heavy");
  const Outcome refused = report("one heavy");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("one and heavy have different decks\n  hint: --pair"));
  ASSERT_EQ(report("one heavy --pair -q dy:min -o pair.csv,pair.html").code, 0);
  const auto rows = lines_of(text("pair.csv"), ".2,heavy,difference,dy:min,m,3,");
  ASSERT_EQ(rows.size(), 1U) << "seeds 2, 3 and 4 are in both";
  EXPECT_TRUE(rows[0].ends_with("\"FRICTN.fric = .2, sweep = one\"")) << rows[0];
}

TEST_F(Report, FaultsSayWhatToDoNext) {
  const auto expect = [&](const std::string& words, int code, const std::string& what) {
    const Outcome run = report(words);
    EXPECT_EQ(run.code, code) << words;
    EXPECT_THAT(run.err, HasSubstr("blocks: error: "));
    EXPECT_THAT(run.err, HasSubstr(what)) << words;
  };
  expect("layer.deck", 5, "is not the folder of a sweep");
  expect("one -q spede:max", 2, "there is no quantity 'spede'");
  expect("one -q y:99", 2, "no run has y:99");
  expect("one -q dy:min@7", 2, "values at times 0 to 0.1, not 7\n  hint: ");
  expect("one --time 7", 2, "not 7\n  hint: choose a --time in this range");
  expect("one --precision 0", 2, "a precision is a number above 0");
  expect("one --pair", 2, "--pair compares two sweeps, found 1");
  expect("one one", 2, "one is named twice");
  expect("one -o report.txt", 2, "must end in .html, .csv, .json, .svg, .pdf or .png");
  expect("one --profile 0,0", 2, "a profile is 'top' or a line");
  sweep("layer.deck --seeds 4-5 --set FRICTN.fric=.6 -o two");
  expect("one two", 2, "both have a run of the same deck with seed 4");
}

// A page of `blocks view` may have the same name.
TEST_F(Report, PagesOfTheUserAreKept) {
  const std::string page = run_folder("one", 1) + "/layer.html";
  folder_.write(page, "mine");
  ASSERT_EQ(report("one").code, 0);
  EXPECT_EQ(text(page + ".bak"), "mine");
  EXPECT_THAT(text(page), HasSubstr("<meta name=\"blocks-report\""));
  fs::last_write_time(folder_ / (run_folder("one", 1) + "/outcome.json"),
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  ASSERT_EQ(report("one").code, 0);
  EXPECT_FALSE(folder_.holds(page + ".bak2")) << "its own page is replaced";
  fs::remove(folder_ / page);
  ASSERT_EQ(::mkfifo((folder_ / page).c_str(), 0600), 0);
  const Outcome fifo = report("one");
  EXPECT_EQ(fifo.code, 0);
  EXPECT_THAT(fifo.err, HasSubstr("layer.html: it is not a regular file"));
}

}  // namespace
}  // namespace blocks::testing
