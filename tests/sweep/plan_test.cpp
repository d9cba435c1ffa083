// The plan of a sweep as a file.
#include "sweep/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "files/file_error.hpp"
#include "sweep/outcome.hpp"

namespace blocks::sweep {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder that exists as long as the test.
class PlanTest : public testing::Test {
 protected:
  PlanTest() { fs::remove_all(folder_); }
  ~PlanTest() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ifstream in(plan_path(folder_));
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write_text(const std::string& text) const {
    std::ofstream(plan_path(folder_)) << text;
  }
  std::string fault_of_reading() const {
    try {
      read_plan(folder_);
    } catch (const files::FileError& fault) {
      return fault.what();
    }
    return "no fault";
  }

  const std::string folder_ =
      testing::TempDir() + "plan_test_" +
      testing::UnitTest::GetInstance()->current_test_info()->name();
};

Plan some_plan() {
  Plan plan;
  plan.deck = "/a/tunnel \"3\".deck";
  plan.deck_hash = "0123456789abcdef";
  plan.version = "1.0.0";
  plan.numerics = numerics();
  plan.name = "tunnel";
  plan.until = 0.1;
  plan.axes = {"seed", "FRICTN.fric"};
  plan.runs = combine({}, {{"FRICTN.fric", {".3", ".5"}}}, {1, 2, 9007199254740991});
  return plan;
}

TEST_F(PlanTest, IsReadAsItWasWritten) {
  write_plan(folder_, some_plan());
  EXPECT_EQ(read_plan(folder_), some_plan());
  Plan bare;
  bare.name = "bare";
  bare.runs.resize(1);
  write_plan(folder_, bare);
  EXPECT_EQ(read_plan(folder_), bare);
}

TEST_F(PlanTest, IsJsonWithOneRunPerLine) {
  write_plan(folder_, some_plan());
  const auto json = nlohmann::json::parse(text());
  EXPECT_EQ(json["runs"].size(), 6U);
  EXPECT_EQ(json["runs"][5]["seed"], 9007199254740991);
  EXPECT_THAT(text(),
              HasSubstr("\n{\"id\":4,\"seed\":1,\"set\":[\"FRICTN.fric=.5\"]},\n"));
}

TEST_F(PlanTest, EveryDamagedPlanIsRefused) {
  write_plan(folder_, some_plan());
  const std::string whole = text();
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    write_text(whole.substr(0, length));
    EXPECT_THAT(fault_of_reading(), HasSubstr("cannot read")) << length;
  }
  std::string swapped = whole;
  swapped.replace(swapped.find("\"id\":2"), 6, "\"id\":3");
  write_text(swapped);
  EXPECT_THAT(fault_of_reading(), HasSubstr("run 2 is not in its place"));
}

TEST_F(PlanTest, ForgedValuesAreRefused) {
  write_plan(folder_, some_plan());
  const std::string whole = text();
  const auto fault = [&](const std::string& before, const std::string& after) {
    std::string forged = whole;
    EXPECT_NE(whole.find(before), std::string::npos) << before;
    write_text(forged.replace(forged.find(before), before.size(), after));
    return fault_of_reading();
  };
  for (const char* name : {"../../X", "/X", "a/b"})
    EXPECT_THAT(fault("\"name\":\"tunnel\"", "\"name\":\"" + std::string(name) + '"'),
                HasSubstr("which cannot be the name of files"));
  EXPECT_THAT(fault("\"kind\":\"run\"", "\"kind\":\"zzz\""),
              HasSubstr("there is no kind \"zzz\""));
  for (const char* number : {"-1", "1e300", "1000001", "18446744073709551615", "0.5"}) {
    EXPECT_THAT(fault("\"number\":6", std::string("\"number\":") + number),
                HasSubstr("not a whole number"));
    EXPECT_THAT(fault("\"seed\":2", std::string("\"seed\":") + number + "e300"),
                HasSubstr("cannot read"));
  }
  for (const char* number : {"-1", "9007199254740992", "\"2\""})
    EXPECT_THAT(fault("\"seed\":2", std::string("\"seed\":") + number),
                HasSubstr("not a whole number"));
  EXPECT_THAT(fault("\"audit\":0", "\"audit\":-1"), HasSubstr("not a whole number"));
  EXPECT_THAT(fault("\"until\":0.1", "\"until\":-1"), HasSubstr("\"until\" is -1"));
  EXPECT_THAT(fault("FRICTN.fric=.3", "FRICTN"), HasSubstr("is not CARD.field=value"));
}

// The message names the field in plain words, not in those of the JSON reader.
TEST_F(PlanTest, ADamagedFieldIsNamed) {
  write_plan(folder_, some_plan());
  const std::string whole = text();
  const auto fault = [&](const std::string& before, const std::string& after) {
    std::string forged = whole;
    write_text(forged.replace(forged.find(before), before.size(), after));
    return fault_of_reading();
  };
  EXPECT_THAT(fault("\"name\":\"tunnel\"", "\"name\":3"),
              HasSubstr("\"name\" is 3, not a text"));
  EXPECT_THAT(fault("\"axes\":", "\"axis\":"), HasSubstr("\"axes\" is missing"));
  EXPECT_THAT(
      fault("\"axes\":[\"seed\",\"FRICTN.fric\"]", "\"axes\":[\"seed\",\"JOINT.ks\"]"),
      HasSubstr("run 1 does not set what \"axes\" names"));
  EXPECT_THAT(fault("\"variants\":[]", "\"variants\":[4]"),
              HasSubstr("\"variants\" is [4], not a list of texts"));
  EXPECT_THAT(fault("\"until\":0.1", "\"until\":\"x\""),
              HasSubstr("\"until\" is \"x\", not a number"));
  EXPECT_THAT(fault("\"kind\":", "kind:"),
              HasSubstr("it has no JSON object with \"blocks_sweep\""));
}

Plan sobol_plan() {
  Plan plan = some_plan();
  plan.axes = {"FRICTN.fric"};
  plan.sobol = SobolDesign{{{"FRICTN.fric", 0.1, 0.7}}, 2, 5};
  plan.runs = sobol_runs(*plan.sobol, {});
  return plan;
}

TEST_F(PlanTest, ASobolDesignIsReadAsItWasWritten) {
  write_plan(folder_, sobol_plan());
  EXPECT_EQ(read_plan(folder_), sobol_plan());
  const std::string whole = text();
  for (const auto& [told, forged] :
       {std::pair{"\"high\":0.7", "\"high\":0.8"}, {"\"low\":0.1", "\"low\":0.0"}}) {
    std::string other = whole;
    write_text(other.replace(other.find(told), std::string(told).size(), forged));
    EXPECT_THAT(fault_of_reading(),
                HasSubstr("its runs are not those of its Sobol design"));
  }
  for (const char* rows : {"0", "1", "3", "-1", "1e300"}) {
    std::string forged = whole;
    write_text(
        forged.replace(forged.find("\"rows\":2"), 8, std::string("\"rows\":") + rows));
    EXPECT_THAT(fault_of_reading(), HasSubstr("cannot read")) << rows;
  }
}

TEST(Plan, AnotherSobolDesignIsTold) {
  const Plan plan = sobol_plan();
  Plan other = plan;
  other.sobol->seed = 6;
  EXPECT_THAT(difference(plan, other), HasSubstr("has 2 rows, seed 5, and FRICTN.fric "
                                                 "= 0.1 to 0.7"));
  other.sobol.reset();
  EXPECT_THAT(difference(plan, other), HasSubstr("are a Sobol design"));
  EXPECT_THAT(difference(other, plan), HasSubstr("are no Sobol design"));
}

TEST_F(PlanTest, AFolderWithoutPlanIsToldSo) {
  EXPECT_FALSE(has_plan(folder_));
  EXPECT_THAT(fault_of_reading(), HasSubstr("is not the folder of a sweep"));
}

TEST(Plan, EveryDifferenceIsTold) {
  const Plan plan = some_plan();
  EXPECT_EQ(difference(plan, plan), "");
  const auto told = [&](const std::function<void(Plan&)>& change) {
    Plan other = plan;
    change(other);
    return difference(plan, other);
  };
  EXPECT_THAT(told([](Plan& p) { p.kind = Kind::check; }), HasSubstr("kind run"));
  EXPECT_THAT(told([](Plan& p) { p.deck = "b"; }), HasSubstr("it sweeps /a/"));
  EXPECT_THAT(told([](Plan& p) { p.deck_hash = ""; }), HasSubstr("has changed"));
  EXPECT_THAT(told([](Plan& p) { p.version = "2"; }), HasSubstr("this is 2"));
  EXPECT_THAT(told([](Plan& p) { p.numerics = "2"; }), HasSubstr("here they are 2"));
  EXPECT_THAT(told([](Plan& p) { p.until.reset(); }), HasSubstr("--until 0.1"));
  EXPECT_THAT(told([](Plan& p) { p.audit_every = 5; }), HasSubstr("--audit=0"));
  EXPECT_THAT(told([](Plan& p) { p.runs.pop_back(); }),
              HasSubstr("6 runs instead of 5"));
  EXPECT_THAT(told([](Plan& p) { p.runs[1].seed = 7; }),
              HasSubstr("run 2 has seed 2, FRICTN.fric=.3 instead of seed 7"));
}

TEST(Plan, TheFolderOfARunHasAThousandNeighbours) {
  EXPECT_EQ(run_folder("d", 42), "d/runs/000/000042");
  EXPECT_EQ(run_folder("d/", 1000000), "d/runs/1000/1000000");
}

TEST_F(PlanTest, AnOutcomeIsReadAsItWasWritten) {
  fs::create_directories(folder_);
  EXPECT_FALSE(has_outcome(folder_));
  EXPECT_FALSE(read_outcome(folder_));
  Outcome outcome{4, "unsound", "a \"contact\"", {{"layers", {{"blocks", 7}}}}};
  write_outcome(folder_, outcome);
  EXPECT_TRUE(has_outcome(folder_));
  const auto read = read_outcome(folder_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->code, 4);
  EXPECT_EQ(read->message, outcome.message);
  EXPECT_EQ(read->measured, outcome.measured);
  std::ofstream(folder_ + "/outcome.json").flush();  // empty, as after a power cut
  EXPECT_FALSE(has_outcome(folder_));
  EXPECT_FALSE(read_outcome(folder_));
  std::ofstream(folder_ + "/outcome.json") << "{";
  EXPECT_THROW(read_outcome(folder_), files::FileError);
  std::ofstream(folder_ + "/outcome.json") << R"({"code":0,"status":3,"message":""})";
  EXPECT_THAT(
      read_outcome_or_damage(folder_)->message,
      HasSubstr("outcome.json is damaged: \"status\" is 3, not a text; remove"));
}

}  // namespace
}  // namespace blocks::sweep
