// The tables of `blocks study contacts DIR`, made from the outcomes of a sweep.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

class StudyTables : public ::testing::Test {
 protected:
  Outcome run(const std::string& words) const { return blocks(words, folder_.path()); }
  Outcome run_well(const std::string& words) const {
    Outcome done = run(words);
    EXPECT_EQ(done.code, 0) << words << done.out << done.err;
    return done;
  }
  std::string text(const std::string& file) const { return slurp(folder_ / file); }

  TemporaryFolder folder_;
};

// Some of these frames hang, differ from the default or have nothing that could hang.
TEST_F(StudyTables, AgreeToTheDigitWithTheStudyOfTheSameFrames) {
  const std::string variants = " --variants default,report,rounded";
  run_well("sweep figure4b,stack,stake --study --seeds 0-6 -o many -q" + variants);
  const Outcome swept = run_well("study contacts many --csv many.csv --json many.json");
  const Outcome studied =
      run_well("study contacts figure4b stack stake --frames 7 --csv one.csv --json "
               "one.json" +
               variants);
  EXPECT_EQ(swept.out, studied.out);
  EXPECT_EQ(text("many.csv"), text("one.csv"));
  EXPECT_EQ(text("many.json"), text("one.json"));
  EXPECT_THAT(text("many.csv"), HasSubstr("\nstake,report,7,"));
}

// A table of fewer frames than planned would look like one of all.
TEST_F(StudyTables, NeedEveryFrame) {
  run_well("sweep tee --study --seeds 4,9 --variants report -o tee -q");
  fs::remove(folder_ / "tee/runs/000/000002/outcome.json");
  const Outcome missing = run("study contacts tee");
  EXPECT_EQ(missing.code, 5);
  EXPECT_THAT(missing.err, HasSubstr("run 2 of tee (seed 9, scene=tee) is not done"));
  EXPECT_THAT(missing.err, HasSubstr("hint: 'blocks sweep tee' goes on with it"));
  const Outcome ungated = run("study contacts tee --gate");
  EXPECT_EQ(ungated.code, 2);
  EXPECT_THAT(ungated.err, HasSubstr("--gate needs the variant default"));
  const Outcome frames = run("study contacts tee --frames 3");
  EXPECT_EQ(frames.code, 2);
  EXPECT_THAT(frames.err, HasSubstr("a sweep has its own scenes, frames and variants"));
}

// The message names the field in plain words.
TEST_F(StudyTables, NameTheFieldThatIsDamaged) {
  run_well("sweep tee --study --seeds 4 --variants report -o tee -q");
  const std::string head = R"({"code":0,"status":"done","message":"","study":)";
  for (const auto& [study, fault] :
       {std::pair{"1", "it has no JSON object with \"steps\""},
        {R"({"steps":"x"})", "\"steps\" is \"x\", not a whole number"},
        {R"({"steps":9})", "\"report\" is missing"},
        {R"({"steps":9,"report":{"could_hang":"x"}})", "\"x\", not a number"}}) {
    folder_.write("tee/runs/000/000001/outcome.json", head + study + "}");
    const Outcome damaged = run("study contacts tee");
    EXPECT_EQ(damaged.code, 5);
    EXPECT_THAT(damaged.err, HasSubstr(fault));
  }
}

TEST_F(StudyTables, RefuseTheSweepOfADeck) {
  folder_.write("a.deck", preliminary() + rectangle(-6, -2, 6, -1, true) + "STOP\n");
  run_well("sweep a.deck --check -o decks -q");
  const Outcome decks = run("study contacts decks");
  EXPECT_EQ(decks.code, 5);
  EXPECT_THAT(decks.err, HasSubstr("decks is not the sweep of a study"));
}

}  // namespace
}  // namespace blocks::testing
