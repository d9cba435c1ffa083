// Counts and messages of `blocks run --audit`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/stepper.hpp"
#include "run/watch/audit_watch.hpp"
#include "scenes/scene.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string pair_of_squares = preliminary() + rectangle(-2, -1, 2, 0, true) +
                                    rectangle(-0.5, 0, 0.5, 1) +
                                    "GRAVITY, 0, -10\nDAMPING, 0.3\n";

TEST(RunAudit, ChangesNoResult) {
  const TemporaryFolder folder;
  run_text(folder, "plain", pair_of_squares + "MOTION, 0.4\nSTOP\n");
  run_text(folder, "audited", pair_of_squares + "MOTION, 0.4\nSTOP\n", "--audit=50");
  const auto plain = summary(folder, "plain"), audited = summary(folder, "audited");
  EXPECT_EQ(plain["state_hash"], audited["state_hash"]);
  EXPECT_TRUE(plain["audit"].is_null());
  const auto& audit = audited["audit"];
  EXPECT_EQ(audit["every"], 50);
  EXPECT_EQ(audit["moments"], (audited["steps"].get<long>() + 49) / 50);
  // Two corners are on the floor. In the first step nothing overlaps yet.
  EXPECT_EQ(audit["acting"], 2 * (audit["moments"].get<long>() - 1));
  EXPECT_EQ(audit["wrong_decisions"], 0);
  EXPECT_EQ(audit["missed_pairs"], 0);
}

TEST(RunAudit, WritesTheSameListingIfTheRunIsResumed) {
  const TemporaryFolder folder;
  run_text(folder, "audited", pair_of_squares + "MOTION, 0.4\nSTOP\n", "--audit=50");
  folder.write("resumed.deck", pair_of_squares + "MOTION, 0.4\nSTOP\n");
  ASSERT_EQ(blocks("run resumed.deck --audit=50 --stop-after 77", folder.path()).code,
            75);
  run_text(folder, "resumed", pair_of_squares + "MOTION, 0.4\nSTOP\n",
           "--audit=50 --restart resumed.ckpt.h5");
  std::string listing = slurp(folder / "resumed.out");
  for (std::size_t at = 0; (at = listing.find("resumed", at)) != std::string::npos;)
    listing.replace(at, 7, "audited");
  EXPECT_EQ(listing, slurp(folder / "audited.out"));
}

// In cut rock some decisions are kept although they would differ now.
TEST(RunAudit, CountsLateDecisions) {
  const TemporaryFolder folder;
  const Outcome run = blocks("run '" BLOCKS_SOURCE_DIR "/decks/slope/slope.deck' "
                             "--set MOTION.dt=0.3 --audit=50",
                             folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto audit = summary(folder, "slope")["audit"];
  EXPECT_EQ(audit["wrong_decisions"], 0);
  EXPECT_GT(audit["late_decisions"].get<long>(), 0);
  EXPECT_LT(audit["late_decisions"].get<long>(), audit["pairs"].get<long>() / 20);
  EXPECT_THAT(run.out + run.err, HasSubstr("kept decisions that would differ now: "));
}

TEST(RunAudit, FindsNoFaultInTheCraterDeck) {
  const TemporaryFolder folder;
  const Outcome run = blocks("run '" BLOCKS_SOURCE_DIR "/decks/crater/crater.deck' "
                             "--set MOTION.dt=0.06 --audit",
                             folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto audit = summary(folder, "crater")["audit"];
  EXPECT_GT(audit["acting"].get<long>(), 1000);
  EXPECT_EQ(audit["faults"], nlohmann::json::array());
  EXPECT_EQ(audit["excess_pairs"], 0);
}

/// A square that rests on a floor, and an audit watch that has recorded one step.
class WatchedStep : public ::testing::Test {
 protected:
  WatchedStep() : watch(1) {
    scene.model.settings.damping = 0.3;
    scene.box(-2, -1, 4, 1, true);
    scene.box(-0.5, 0, 1, 1);
    scene.gravity(0, -10);
    scene.run(0.4);
    dynamics::Workspace work;
    dynamics::Stepper stepper(scene.model, work);
    watch.keep_start(stepper.up_to_date());
    stepper.advance(true);
    stepper.up_to_date();
    listed = stepper.listed_pairs();
  }
  scenes::Scene scene;
  run::AuditWatch watch;
  std::vector<std::pair<int, int>> listed;
};

TEST_F(WatchedStep, HasNoFaultIfItIsSound) {
  const auto verdict = watch.audit_step(scene.model, listed);
  EXPECT_TRUE(verdict.faults.empty());
  EXPECT_TRUE(verdict.stories.empty());
  EXPECT_EQ(watch.totals().pairs, 1);
  EXPECT_EQ(watch.totals().acting, 2);
  EXPECT_THAT(
      watch.summary(),
      HasSubstr("audit every 1 step: 1 audit, 1 pair of blocks near each other, 2 "
                "acting contacts; pairs missed: 0; wrong decisions: 0; "));
}

TEST_F(WatchedStep, ReportsMissedPairsAndWrongDecisions) {
  listed.clear();
  scene.model.contacts.erase(scene.model.contacts.begin());
  const auto verdict = watch.audit_step(scene.model, listed);
  ASSERT_EQ(verdict.faults.size(), 2U);
  EXPECT_THAT(verdict.faults[0],
              HasSubstr("audit: the list of near pairs misses blocks 1 and 2"));
  EXPECT_THAT(
      verdict.faults[1],
      HasSubstr("audit: wrong decision about blocks 1 and 2: the run has corner 4 of "
                "block 2 on edge 2 of block 1; exact is corner 1 of block 2 on edge 2 "
                "of block 1; corner 4 of block 2 on edge 2 of block 1"));
  EXPECT_THAT(verdict.stories, ::testing::Contains(HasSubstr("acts")));
  EXPECT_EQ(watch.totals().missed, 1);
  EXPECT_EQ(watch.totals().wrong, 1);
  EXPECT_EQ(watch.totals().faults, verdict.faults);
}

TEST(RunAudit, RefusesAnIntervalThatIsNoWholeNumberOfSteps) {
  const TemporaryFolder folder;
  folder.write("a.deck", pair_of_squares + "CYCLE, 5\nSTOP\n");
  for (const char* value : {"0", "-1", "1.5", "x", "99999999999999999999"}) {
    const Outcome run =
        blocks(std::string("run a.deck --audit=") + value, folder.path());
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("expected a number of steps, 1 or more")) << value;
  }
}

TEST(RunAudit, NeedsNoNumberOfSteps) {
  const TemporaryFolder folder;
  folder.write("a.deck", pair_of_squares + "CYCLE, 5\nSTOP\n");
  EXPECT_EQ(blocks("run --audit a.deck -o b", folder.path()).code, 0);
}

TEST(RunAudit, SaysHowTheIntervalIsWritten) {
  const TemporaryFolder folder;
  folder.write("t.deck", pair_of_squares + "STOP\n");
  for (const char* words : {"run --audit 5 t.deck", "run t.deck --audit 5"}) {
    const Outcome done = blocks(words, folder.path());
    EXPECT_EQ(done.code, 2);
    EXPECT_THAT(done.err, HasSubstr("write --audit=5 to audit every 5 steps")) << words;
  }
}

}  // namespace
}  // namespace blocks::testing
