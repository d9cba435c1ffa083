// The factor of safety F in a report. The runs were not made: their outcomes are
// written here, as the FOS card would have them.
#include "report/factor_of_safety.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sweep/outcome.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using report::FailureCount;
using report::SafetyBracket;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(SafetyBracket, ALimitIsDecidedByTheProvedEnds) {
  const double none = report::no_number;
  const report::Measure::Limit below{false, 1.0}, above{true, 1.0};
  EXPECT_EQ((SafetyBracket{0.98, 1.0}).decide(below), 1.0) << "upper <= 1";
  EXPECT_EQ((SafetyBracket{1.0, 1.01}).decide(below), 0.0) << "lower >= 1";
  EXPECT_EQ((SafetyBracket{1.0, 1.01}).decide(above), 1.0);
  EXPECT_TRUE(std::isnan((SafetyBracket{0.995, 1.005}).decide(below)));
  EXPECT_EQ((SafetyBracket{none, 0.5}).decide(below), 1.0);
  EXPECT_EQ((SafetyBracket{2.0, none}).decide(below), 0.0);
  EXPECT_TRUE(std::isnan((SafetyBracket{0.5, none}).decide(below)));
  EXPECT_TRUE(std::isnan((SafetyBracket{0.5, none}).middle()));
}

TEST(SafetyBracket, UndecidedRunsAreToldAndCountAsNeither) {
  FailureCount count;
  for (int i = 0; i < 3; ++i)
    count.add({0.9, 0.91});
  for (int i = 0; i < 17; ++i)
    count.add({1.2, 1.21});
  count.add({0.99, 1.01});
  EXPECT_EQ(report::failure_words(count), "F < 1 in 3 of 20 runs: 15 % (95 % interval "
                                          "5.24 to 36 %); 1 run is undecided");
  EXPECT_EQ(report::failure_words({0, 0, 2}),
            "F < 1 is not decided in any run; 2 runs are undecided");
}

TEST(SafetyOutcome, IsThatOfTheSummary) {
  const auto of = [&](const char* summary) {
    return sweep::safety_outcome(nlohmann::ordered_json::parse(summary));
  };
  EXPECT_EQ(of(R"({"factor_of_safety": {"lower": 1.39, "upper": null,
                   "trials": [{"factor": 1.39, "outcome": "stable"}]}})")
                .dump(),
            R"({"lower":1.39,"upper":null})");
  for (const char* without : {R"({"steps": 3})", "null"})
    EXPECT_TRUE(of(without).is_null()) << without;
}

class SafetyReport : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("a.deck", preliminary() + rectangle(-6, -2, 6, -1, true) +
                                "LAYER, -6, 1, -5,0, -5,1, 5,1, 5,0, RANDOM\n"
                                "FRICTN, 0.5\nMOTION, 0.1\n");
    const Outcome run =
        blocks("sweep a.deck --seeds 1-4 --set FRICTN.fric=.2,.6 -o s --dry-run",
               folder_.path());
    ASSERT_EQ(run.code, 0) << run.err;
    set(1, "0.89", "0.9");
    set(2, "0.99", "1.01");
    set(3, "0.95", "1");
    set(4, "1.1", "1.11");
    for (int id = 5; id <= 7; ++id)
      set(id, "1.3", "1.31");
    set(8, "2", "null");
  }
  void set(int id, const std::string& lower, const std::string& upper) const {
    write(id, R"(, "factor_of_safety": {"lower": )" + lower + R"(, "upper": )" + upper +
                  "}");
  }
  void write(int id, const std::string& measured) const {
    const std::string place = "s/runs/000/00000" + std::to_string(id);
    fs::create_directories(folder_ / place);
    folder_.write(place + "/outcome.json",
                  R"({"code": 0, "status": "done", "message": "")" + measured + "}");
  }
  Outcome report(const std::string& words) const {
    return blocks("report s " + words, folder_.path());
  }
  std::string text(const std::string& file) const { return slurp(folder_ / file); }
  TemporaryFolder folder_;
};

TEST_F(SafetyReport, HasTheDistributionAndTheShareBelowOne) {
  const Outcome run = report("-q 'fos,fos_lower,fos<1' -o t.csv,t.json,t.html");
  ASSERT_EQ(run.code, 0) << run.err;
  // Runs with different friction are never added.
  EXPECT_THAT(run.out, HasSubstr("F < 1 in 2 of 3 runs: 66.7 % (95 % interval 20.8 to "
                                 "93.9 %); 1 run is undecided"));
  EXPECT_THAT(run.out,
              HasSubstr("F < 1 in 0 of 4 runs: 0 % (95 % interval 0 to 49 %)"));
  const std::string table = text("t.csv");
  EXPECT_THAT(table, HasSubstr("\n.2,quantity,fos,,4,0,,0.99375,"));
  EXPECT_THAT(table, HasSubstr("\n.2,quantity,fos<1,,3,1,2,0.666666666666666"));
  EXPECT_THAT(table, HasSubstr("\n.6,quantity,fos,,3,1,,1.305"));
  EXPECT_THAT(table, HasSubstr("\n.6,quantity,fos_lower,,4,0,,1.475,"));
  EXPECT_THAT(table, HasSubstr("\n.6,quantity,fos<1,,4,0,0,0,0,0.489"));
  EXPECT_THAT(text("t.json"), HasSubstr("\"undecided\": 1"));
  EXPECT_THAT(text("t.html"), HasSubstr("<h2>Factor of safety</h2>"));
}

TEST_F(SafetyReport, FiguresShowItAgainstTheParameter) {
  ASSERT_EQ(report("-q 'fos,fos<1' -o f.svg --size 85mm").code, 0);
  EXPECT_THAT(text("f-mean-fos-1.svg"), HasSubstr("95 % interval (Wilson)"));
  EXPECT_THAT(text("f-histogram-fos.svg"), HasSubstr(">factor of safety</text>"));
}

TEST_F(SafetyReport, OfRunsWithoutFSaysSo) {
  for (int id = 1; id <= 8; ++id)
    write(id, "");
  const Outcome run = report("-q fos -o t.csv");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("no run has fos\n  hint: the FOS card"));
  ASSERT_EQ(report("-o t.csv").code, 0);
  EXPECT_THAT(text("t.csv"), Not(HasSubstr("fos")));
}

}  // namespace
}  // namespace blocks::testing
