// SOLVE makes steps until the forces are balanced, also in parts, and tells how it
// ended.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/equilibrium.hpp"
#include "run/support/progress_line.hpp"
#include "run/watch/convergence.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using run::Convergence;
using ::testing::HasSubstr;
using ::testing::Not;

/// A brick on the floor, block 2, falls by 0.01 and comes to rest.
const std::string brick = preliminary() + rectangle(-5, -1, 5, 0, true) +
                          rectangle(0, 0.01, 1, 1.01) +
                          "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\n";

nlohmann::json solved(const TemporaryFolder& folder, const std::string& name) {
  return summary(folder, name).at("solves");
}

/// A model with one free block of weight 1 whose unbalanced ratio is `ratio`.
Model with_ratio(double ratio) {
  Model model;
  model.settings.rigid = true;
  model.settings.gravity = {0.0, -1.0};
  model.blocks.append({{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 1, 1.0}});
  model.blocks.force.col(0) = Vec2(0.0, 1.0 - ratio);
  return model;
}

/// Makes ten steps. Only the last one is tested.
void ten_steps(Convergence& convergence, double ratio) {
  const Model model = with_ratio(ratio);
  for (int i = 1; i <= 10; ++i) {
    EXPECT_EQ(convergence.is_due(), i == 10);
    convergence.after_step(model);
  }
}

deck::Solve card(double ratio, long max) { return {{ratio, {}}, {max, {}}}; }

// A swinging block passes F = 0.
TEST(Convergence, NeedsTwoSuccessiveTests) {
  Convergence convergence(card(1e-3, 1000));
  for (const double ratio : {0.5, 1e-4, 0.2, 1e-4}) {
    ten_steps(convergence, ratio);
    EXPECT_FALSE(convergence.is_finished()) << ratio;
  }
  ten_steps(convergence, 1e-4);
  EXPECT_TRUE(convergence.is_finished());
  EXPECT_EQ(convergence.record(with_ratio(1e-4), 3).steps, 50);
}

// The last step is tested too, but too soon after the test before it.
TEST(Convergence, NeedsTenStepsBetweenItsTests) {
  Convergence convergence(card(1e-3, 21));
  ten_steps(convergence, 0.5);
  ten_steps(convergence, 1e-4);
  convergence.after_step(with_ratio(1e-4));
  EXPECT_TRUE(convergence.is_finished());
  EXPECT_FALSE(convergence.is_balanced());
}

TEST(Convergence, WaitsForTheEndOfARampAndOfLoads) {
  Model model = with_ratio(0.0);
  model.settings.gravity_ramp = {{0, 0}, 1.0, 2.0};
  model.time = 2.9;
  EXPECT_TRUE(loads_will_change(model));
  model.time = 3.0;
  EXPECT_FALSE(loads_will_change(model));
  model.loads.function = {{0, 1, 2}, {0, 1, 1}};
  model.loads.forces = {{0, {1, 0}, 2.5}};
  EXPECT_TRUE(loads_will_change(model)) << "f changes until 3.5";
  model.time = 3.5;
  EXPECT_FALSE(loads_will_change(model));

  model.loads = {};
  model.settings.gravity_ramp = {{0, -1}, 3.0, 1.0};
  Convergence convergence(card(1e-3, 1000));
  for (int i = 0; i < 30; ++i)
    convergence.after_step(model);
  EXPECT_FALSE(convergence.is_balanced());
}

// By rounding, the time of the last step may be before the card.
TEST(GravityRamp, HasAValueAtEveryTime) {
  Settings settings;
  settings.gravity = {0, -10};
  settings.gravity_ramp = {{0, -2}, 1.0, 0.0};
  EXPECT_EQ(settings.gravity_at(0.999), Vec2(0, -10));
  settings.gravity_ramp.duration = 4.0;
  EXPECT_EQ(settings.gravity_at(0.999), Vec2(0, -2));
  EXPECT_EQ(settings.gravity_at(3.0), Vec2(0, -6));
  EXPECT_EQ(settings.gravity_at(5.0), Vec2(0, -10));
}

TEST(Solve, IsNotBalancedWhileAServoHoldsTooLittle) {
  const TemporaryFolder folder;
  // The platen, block 3, is half a unit above the brick and moves too slowly.
  folder.write("far.deck",
               preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
                   rectangle(0, 1.5, 1, 2, true) +
                   "LOCDAMP\nSERVO, 3, 4, -1.E5, .001\nSOLVE, 1.E-3, 100\n");
  const Outcome run = blocks("run far.deck", folder.path());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("has not converged"));
  EXPECT_THAT(run.err, HasSubstr("is that of block 3"));
  EXPECT_EQ(summary(folder, "far")["converged"], false);
}

TEST(Convergence, RemembersTheTestBeforeARestart) {
  Convergence before(card(1e-3, 1000));
  ten_steps(before, 1e-4);
  Convergence after(card(1e-3, 1000), 10, before.is_below());
  ten_steps(after, 1e-4);
  EXPECT_TRUE(after.is_balanced());
}

TEST(Convergence, EstimatesItsShareFromTheLogarithmAndNeverGoesBack) {
  Convergence convergence(card(1e-4, 1'000'000));
  ten_steps(convergence, 1.0);
  EXPECT_NEAR(convergence.share(), 0.0, 1e-4);
  ten_steps(convergence, 1e-2);
  EXPECT_NEAR(convergence.share(), 0.5, 1e-6);
  ten_steps(convergence, 1e-1);
  EXPECT_NEAR(convergence.share(), 0.5, 1e-6);
}

TEST(ProgressLine, HasTheRatioDuringSolve) {
  run::RunProgress at{0.5, 60.0, 1000, 0.5, {}};
  at.balance.ratio = 3.21e-4;
  EXPECT_THAT(run::progress_line(at, 80), HasSubstr(" ratio 3.2e-04 "));
  EXPECT_THAT(run::log_line(at), HasSubstr("progress 50 %: ratio 3.2e-04, step 1000"));
  at.balance = {};
  EXPECT_THAT(run::log_line(at), Not(HasSubstr("ratio")));
}

TEST(Solve, EndsWhenTheForcesAreBalanced) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a", brick + "SOLVE, 1.E-6\nMOTION, 0.01\nSTOP\n");
  const auto end = summary(folder, "a");
  const auto solve = end["solves"][0];
  EXPECT_TRUE(end["converged"]);
  EXPECT_TRUE(solve["converged"]);
  EXPECT_LE(solve["reached"], 1e-6);
  EXPECT_EQ(solve["steps"].get<long>() % 10, 0);
  EXPECT_LT(solve["time"], end["time"]);  // the deck continues
  EXPECT_THAT(run.err, HasSubstr("SOLVE in line "));
  EXPECT_THAT(run.err, Not(HasSubstr("warning")));
}

TEST(Solve, WarnsAndContinuesIfItDoesNotConverge) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a", brick + "SOLVE, 1.E-6, 40\nMOTION, 0.01\nSTOP\n");
  const auto end = summary(folder, "a");
  EXPECT_FALSE(end["converged"]);
  EXPECT_EQ(end["solves"][0]["steps"], 40);
  EXPECT_NEAR(end["solves"][0]["reached"], 1.0, 1e-9);  // free fall
  EXPECT_EQ(end["solves"][0]["largest_unbalanced"]["block"], 2);
  EXPECT_GT(end["steps"], 40);
  EXPECT_THAT(run.err, HasSubstr("has not converged: ratio 1 after 40 steps, wanted "
                                 "1e-06; the largest unbalanced force, 9.81e+03, is "
                                 "that of block 2 (blocks plot --colour unbalanced)"));
}

// Test positions are counted from the beginning of the card, and the test before the
// restart counts.
TEST(Solve, HasTheSameBitsInParts) {
  const TemporaryFolder folder;
  const std::string deck = brick + "MOTION, 0.0123\nSOLVE, 1.E-4\nMOTION, 0.01\nSTOP\n";
  run_text(folder, "whole", deck);
  const auto whole = summary(folder, "whole");
  const long begin = 31, end = begin + solved(folder, "whole")[0]["steps"].get<long>();
  for (const long stop : {begin + 1, begin + 14, end - 10, end - 5, end}) {
    folder.write("parts.deck", deck);
    ASSERT_EQ(
        blocks("run parts.deck --stop-after " + std::to_string(stop), folder.path())
            .code,
        75);
    ASSERT_EQ(blocks("run parts.deck --restart parts.ckpt.h5", folder.path()).code, 0);
    const auto parts = summary(folder, "parts");
    for (const char* key : {"state_hash", "steps", "time", "solves", "warnings"})
      EXPECT_EQ(parts[key], whole[key]) << key << " after a stop at step " << stop;
  }
}

TEST(Solve, StopsAtTheTimeOfUntilAndGoesOn) {
  const TemporaryFolder folder;
  const std::string deck = brick + "SOLVE, 1.E-6\nSTOP\n";
  run_text(folder, "whole", deck);
  run_text(folder, "parts", deck, "--until 0.01");
  EXPECT_TRUE(solved(folder, "parts").empty());
  EXPECT_FALSE(summary(folder, "parts")["converged"]);
  ASSERT_EQ(blocks("run parts.deck --restart parts.ckpt.h5", folder.path()).code, 0);
  EXPECT_EQ(summary(folder, "parts")["state_hash"],
            summary(folder, "whole")["state_hash"]);
}

TEST(Solve, WarnsIfNothingDampsTheMotion) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a", brick + "DAMPING, 0\nSOLVE, 1.E-6, 20\nSTOP\n");
  EXPECT_THAT(run.err, HasSubstr("warning: SOLVE: nothing damps the motion"));
  for (const char* damping : {"LOCDAMP, .8\n", "KINDAMP\n"}) {
    const Outcome damped = run_text(
        folder, "b", brick + "DAMPING, 0\n" + damping + "SOLVE, 1.E-6, 20\nSTOP\n");
    EXPECT_THAT(damped.err, Not(HasSubstr("nothing damps")));
  }
}

TEST(Solve, RefusesRatiosAndStepsThatCannotWork) {
  const TemporaryFolder folder;
  for (const char* card : {"SOLVE, 0", "SOLVE, 1", "SOLVE, -1.E-5", "SOLVE, , 19"}) {
    folder.write("a.deck", brick + card + "\nSTOP\n");
    EXPECT_EQ(blocks("check a.deck", folder.path()).code, 3) << card;
  }
}

}  // namespace
}  // namespace blocks::testing
