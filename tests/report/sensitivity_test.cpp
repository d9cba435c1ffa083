// A sweep with a Sobol design in a report. The runs were not made: their outcomes are
// written here, with a factor of safety that is a known function of the parameters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "sweep/plan.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Sensitivity : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("a.deck", preliminary() + rectangle(-6, -2, 6, -1, true) +
                                "LAYER, -6, 1, -5,0, -5,1, 5,1, 5,0, RANDOM\n"
                                "FRICTN, 0.5\nGRAVITY, 0, -10\nMOTION, 0.1\n");
    const Outcome run =
        blocks("sweep a.deck --sobol FRICTN.fric=0.2..0.6,GRAVITY.gravy=-12..-10 "
               "-n 64 -o s --dry-run",
               folder_.path());
    ASSERT_EQ(run.code, 0) << run.err;
    const sweep::Plan plan = sweep::read_plan((folder_ / "s").string());
    ASSERT_EQ(plan.runs.size(), 256U);
    for (std::size_t id = 1; id <= plan.runs.size(); ++id) {
      const auto value = [&](std::size_t i) {
        return std::stod(sweep::value_of(plan.runs[id - 1].sets.at(i)));
      };
      // The variances are as 0.4^2 : (2 * 0.1)^2 = 4 : 1.
      set(id, value(0) + 0.1 * value(1) + 2.0);
    }
  }
  void write(std::size_t id, const std::string& json) const {
    const fs::path place = sweep::run_folder((folder_ / "s").string(), id);
    fs::create_directories(place);
    folder_.write(place.lexically_relative(folder_.path()).string() + "/outcome.json",
                  json);
  }
  void set(std::size_t id, double fos) const {
    const nlohmann::json outcome = {
        {"code", 0},
        {"status", "done"},
        {"message", ""},
        {"factor_of_safety", {{"lower", fos}, {"upper", fos}}}};
    write(id, outcome.dump());
  }
  Outcome report(const std::string& words) const {
    const Outcome run = blocks("report s -q fos " + words, folder_.path());
    EXPECT_EQ(run.code, 0) << run.err;
    return run;
  }
  std::string text(const std::string& file) const { return slurp(folder_ / file); }
  TemporaryFolder folder_;
};

TEST_F(Sensitivity, IndicesAreInAllTables) {
  const Outcome run = report("-o t.json,t.csv,t.html");
  EXPECT_THAT(run.out, HasSubstr("256 runs of a.deck: Sobol design of 64 rows, "
                                 "FRICTN.fric = 0.2 to 0.6, GRAVITY.gravy = -12 to "
                                 "-10"));
  EXPECT_THAT(run.out, HasSubstr("\nSobol indices of fos, 64 rows\n"));
  const auto json = nlohmann::json::parse(text("t.json"));
  const auto& indices = json["sobol_indices"][0]["quantities"][0]["indices"];
  ASSERT_EQ(indices.size(), 2U);
  EXPECT_EQ(indices[1]["parameter"], "GRAVITY.gravy");
  EXPECT_NEAR(indices[0]["first_order"]["value"].get<double>(), 0.8, 0.05);
  EXPECT_NEAR(indices[0]["total"]["value"].get<double>(), 0.8, 0.05);
  EXPECT_NEAR(indices[1]["first_order"]["value"].get<double>(), 0.2, 0.05);
  EXPECT_NEAR(indices[1]["total"]["value"].get<double>(), 0.2, 0.05);
  const std::string table = text("t.csv");
  EXPECT_THAT(table, HasSubstr("\nfirst_order,fos,,64,0,,0."));
  const auto total = table.find("\ntotal,fos,,64,0,,0.");
  ASSERT_NE(total, std::string::npos);
  std::istringstream line(table.substr(total + 1));
  std::string row;
  std::getline(line, row);
  EXPECT_TRUE(row.ends_with(",FRICTN.fric")) << row;
  EXPECT_EQ(std::count(row.begin(), row.end(), ','),
            std::count(table.begin(), table.begin() + table.find('\n'), ','));
  EXPECT_THAT(text("t.html"), HasSubstr("<h2>Sensitivity</h2>"));
}

// The mixed runs share all but one coordinate with another run of their row.
TEST_F(Sensitivity, StatisticsCountTheIndependentRunsOnly) {
  report("-o t.csv --run-table runs.csv");
  EXPECT_THAT(text("t.csv"), HasSubstr("\nquantity,fos,,128,0,,"));
  const std::string runs = text("runs.csv");
  EXPECT_THAT(runs, HasSubstr("run,FRICTN.fric,GRAVITY.gravy,seed,"));
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 257);
}

TEST_F(Sensitivity, RowsWithARunWithoutAValueAreLeftOutAndTold) {
  write(7, R"({"code": 0, "status": "done", "message": "",
               "factor_of_safety": {"lower": 0.5, "upper": null}})");
  write(9, R"({"code": 4, "status": "unsound", "message": "too deep"})");
  EXPECT_THAT(report("-o t.csv").out,
              HasSubstr("\nSobol indices of fos, 62 of 64 rows; 2 left out, because a "
                        "run has no value\n"));
}

TEST_F(Sensitivity, TheFigureNamesTheParameters) {
  report("-o f.svg,f.pdf --size 85mm");
  EXPECT_THAT(text("f-sobol-fos.svg"), HasSubstr(">FRICTN.fric</text>"));
  EXPECT_THAT(text("f-sobol-fos.svg"),
              HasSubstr(">Sobol index of factor of safety</text>"));
  EXPECT_THAT(text("f-sobol-fos.svg"), Not(HasSubstr("nan")));
  EXPECT_TRUE(text("f-sobol-fos.pdf").starts_with("%PDF"));
}

}  // namespace
}  // namespace blocks::testing
