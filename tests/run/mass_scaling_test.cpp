// SOLVE with MSCALE: the same equilibrium in fewer steps, with the same bits in parts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "post/results_reader.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Two slabs of 4 x 2 on a floor, with 16 cubes of 0.1 in a gap of the lower joint and
/// a cube of 1 on top.
std::string graded(const std::string& damping, const std::string& kind = "RIGID\n") {
  std::string text = preliminary(kind);
  text.replace(text.find("0.1\nSTIFF"), 3, "0.01");  // ctol
  text += rectangle(-6, -1, 6, 0, true) + rectangle(-2, 0, 2, 2) +
          rectangle(-2, 2.1, 2, 4.1);
  for (int i = 0; i < 16; ++i)
    text += rectangle(-2 + 0.25 * i, 2, -1.9 + 0.25 * i, 2.1);
  return text + rectangle(-0.5, 4.1, 0.5, 5.1) + "GRAVITY, 0, -9.81\nFRICTN, 0.5\n" +
         damping;
}

post::Frame last_frame(const TemporaryFolder& folder, const std::string& name) {
  const post::ResultsReader results((folder / (name + ".vtkhdf")).string());
  return results.frame(results.frames() - 1);
}

void expect_same_rest_in_fewer_steps(const std::string& deck) {
  const TemporaryFolder folder;
  run_text(folder, "plain", deck + "SOLVE, 1.E-6, 400000\nSTOP\n");
  run_text(folder, "scaled", deck + "MSCALE\nSOLVE, 1.E-6, 400000\nSTOP\n");
  const auto plain = summary(folder, "plain"), scaled = summary(folder, "scaled");
  EXPECT_TRUE(plain["converged"]);
  EXPECT_TRUE(scaled["converged"]);
  EXPECT_LT(3 * scaled["solves"][0]["steps"].get<long>(),
            plain["solves"][0]["steps"].get<long>());
  const post::Frame a = last_frame(folder, "plain"), b = last_frame(folder, "scaled");
  const double sunk = 2e-2 * (a.centroid(1, 2) - 3.1);  // of the upper slab
  EXPECT_LT(sunk, 0.0);
  EXPECT_LT((a.centroid - b.centroid).cwiseAbs().maxCoeff(), -sunk);
}

TEST(MassScaling, FindsTheSameRestInFewerSteps) {
  expect_same_rest_in_fewer_steps(graded("LOCDAMP, .8\n"));
}
TEST(MassScaling, FindsItWithDashpotsToo) {
  expect_same_rest_in_fewer_steps(graded("LOCDAMP, .5\nDAMPING, .2\n"));
}
TEST(MassScaling, FindsItForDeformableBlocks) {
  expect_same_rest_in_fewer_steps(graded("LOCDAMP, .8\nMDAMP, 1, .1\n", ""));
}
TEST(MassScaling, IsToldAndEndsWithSolve) {
  const TemporaryFolder folder;
  const Outcome run = run_text(
      folder, "a", graded("LOCDAMP, .8\n") + "MSCALE\nSOLVE, 1.E-4\nCYCLE, 5\nSTOP\n");
  const auto end = summary(folder, "a");
  const auto solve = end["solves"][0];
  EXPECT_LT(solve["mass_scaling"]["least"], 1.0);
  EXPECT_GT(solve["mass_scaling"]["largest"], 10.0);
  EXPECT_GT(solve["time_step"], end["dt"]["value"]);
  EXPECT_THAT(run.err, HasSubstr("SOLVE scales masses by "));
  EXPECT_THAT(slurp(folder / "a.out"), HasSubstr("masses scaled by "));
  EXPECT_THAT(run.err, Not(HasSubstr("warning")));
}

TEST(MassScaling, HasTheSameBitsInPartsAndWithThreads) {
  const TemporaryFolder folder;
  const std::string deck =
      graded("LOCDAMP, .8\nDAMPING, .1\n") +
      "MOTION, 0.001\nMSCALE\nSOLVE, 1.E-5\nREMOVE, 20\nMOTION, 0.001\nSTOP\n";
  run_text(folder, "whole", deck, "-j 1");
  const auto whole = summary(folder, "whole");
  run_text(folder, "threads", deck, "-j 3");
  EXPECT_EQ(summary(folder, "threads")["state_hash"], whole["state_hash"]);
  const long steps = whole["solves"][0]["steps"];
  const long begin = (whole["steps"].get<long>() - steps) / 2;  // equal motions
  for (const long stop : {begin + 1, begin + steps / 2, begin + steps}) {
    folder.write("parts.deck", deck);
    ASSERT_EQ(
        blocks(fmt::format("run parts.deck --stop-after {}", stop), folder.path()).code,
        75);
    ASSERT_EQ(blocks("run parts.deck --restart parts.ckpt.h5", folder.path()).code, 0);
    const auto parts = summary(folder, "parts");
    for (const char* key : {"state_hash", "steps", "time", "dt", "solves"})
      EXPECT_EQ(parts[key], whole[key]) << key << " after a stop at step " << stop;
  }
}

TEST(MassScaling, DoesNotOutliveAnInterruptedSolve) {
  const TemporaryFolder folder;
  run_text(folder, "a", graded("LOCDAMP, .8\n") + "CYCLE, 1\nSTOP\n");
  folder.write("b.deck", graded("LOCDAMP, .8\n") + "MSCALE\nSOLVE, 1.E-7\nSTOP\n");
  ASSERT_EQ(blocks("run b.deck --stop-after 50", folder.path()).code, 75);
  run_text(folder, "c", "RESTART, b\nCYCLE, 1\nSTOP\n");
  EXPECT_EQ(summary(folder, "c")["dt"], summary(folder, "a")["dt"]);
}

// Kinetic energy is that of the inertial masses, so the sum closes.
TEST(MassScaling, ClosesTheEnergyAccount) {
  const TemporaryFolder folder;
  run_text(folder, "a",
           graded("LOCDAMP, .8\nDAMPING, .1\n") +
               "HISTORY, 1, energy:residual\nMSCALE\nSOLVE, 1.E-5\nSTOP\n");
  const auto energy = summary(folder, "a")["energy"];
  EXPECT_GT(energy["artificial"], 0.0);
  EXPECT_LT(std::abs(energy["residual"].get<double>()),
            1e-9 * energy["gravity"].get<double>());
}

}  // namespace
}  // namespace blocks::testing
