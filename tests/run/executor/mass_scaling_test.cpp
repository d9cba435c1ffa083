// SOLVE with MSCALE: the same equilibrium in fewer steps, with the same bits in parts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

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
/// Voronoi cells that grow from 2 cm to 1.1 m between three fixed blocks. All sides are
/// bonded and elastic, so that there is only one place of rest.
std::string bonded_cells(const TemporaryFolder& folder, const std::string& damping,
                         const std::string& kind) {
  std::string points = "x,y\n";
  double size = 0.0, fraction = 0.0;
  const auto jitter = [&] {
    constexpr double golden = 0.6180339887498949;
    fraction += golden;
    return 0.4 * (fraction - std::floor(fraction) - 0.5);
  };
  for (double x = 0.0; x < 6.0; x += size) {
    size = 0.02 + 0.18 * x;
    for (int i = 0; i < std::clamp(static_cast<int>(2.0 / size), 1, 10); ++i) {
      const double at = x + size * (0.5 + jitter()), y = size * (i + 0.5 + jitter());
      if (at < 6.0 && y < 2.0)
        points += fmt::format("{}, {}\n", at, y);
    }
  }
  folder.write("points.csv", points);
  std::string text = preliminary(kind);
  text.replace(text.find("100, 6"), 6, "400, 20");
  text.replace(text.find("0.1\nSTIFF"), 3, "0.002");  // ctol
  return text + rectangle(-1, -1, 7, 0, true) + rectangle(-1, 0, 0, 2, true) +
         rectangle(6, 0, 7, 2, true) +
         "OUTLINE, 4, 1\n0, 0, 6, 6\n0, 2, 2, 0\nVORONOI, , , 1, points.csv\nCUT\n"
         "JOINT, 1, .7, 1.E9, 1.E9\nJPAIR, 1, 1, 1\nBOND\nGRAVITY, 0, -9.81\n" +
         damping;
}

void expect_one_place_of_rest(const std::string& damping, const std::string& kind) {
  const TemporaryFolder folder;
  const std::string deck = bonded_cells(folder, damping, kind);
  const std::string solve = "SOLVE, 1.E-6, 400000\nSTOP\n";
  run_text(folder, "plain", deck + solve);
  run_text(folder, "scaled", deck + "MSCALE\n" + solve);
  const auto steps = [&](const char* name) {
    const auto found = summary(folder, name)["solves"][0];
    EXPECT_TRUE(found["converged"]);
    return found["steps"].get<double>();
  };
  EXPECT_LT(5.0 * steps("scaled"), steps("plain"));
  const post::ResultsReader plain((folder / "plain.vtkhdf").string());
  const Eigen::MatrixXd begin = plain.frame(0).centroid,
                        end = last_frame(folder, "plain").centroid,
                        scaled = last_frame(folder, "scaled").centroid;
  const double motion = (end - begin).cwiseAbs().maxCoeff();
  EXPECT_LT((end - scaled).cwiseAbs().maxCoeff(), 1e-4 * motion);
}

TEST(MassScaling, BringsBondedCellsToTheSamePlaces) {
  expect_one_place_of_rest("LOCDAMP, .8\n", "RIGID\n");
}
TEST(MassScaling, BringsThemThereWithDashpotsToo) {
  expect_one_place_of_rest("LOCDAMP, .5\nDAMPING, .2\n", "RIGID\n");
}
TEST(MassScaling, BringsDeformableOnesThere) {
  expect_one_place_of_rest("LOCDAMP, .8\n", "");
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
