// The time step that the program chooses if FRACTION is blank is stable for packed
// rock, however it was cut: judged by the highest frequency of the contacts that act.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "output/checkpoint/checkpoint.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

constexpr double stiffness = 1e9, alpha = 0.8;

/// Returns the highest frequency of all free blocks on springs at the contacts that
/// act, with the same stiffness along and across the contact, 1/T.
double highest_frequency(const Model& model) {
  const Blocks& blocks = model.blocks;
  using Matrix = Eigen::MatrixXd;
  Matrix all = Matrix::Zero(3 * blocks.size(), 3 * blocks.size());
  for (const Contact& contact : model.contacts) {
    const auto [low, high] = pair_of(blocks, contact);
    // The displacements that both blocks give the contact, in units of root mass.
    Eigen::Matrix<double, 2, 6> both = Eigen::Matrix<double, 2, 6>::Zero();
    double sign = 1.0;
    for (const int b : {low, high}) {
      if (blocks.is_free(b)) {
        const Vec2 arm = blocks.corner.col(contact.corner) - blocks.centroid.col(b);
        const double mass = std::sqrt(blocks.mass[b]),
                     inertia = std::sqrt(blocks.inertia[b]);
        Eigen::Matrix<double, 2, 3> one;
        one << 1.0 / mass, 0.0, -arm.y() / inertia, 0.0, 1.0 / mass, arm.x() / inertia;
        both.middleCols<3>(b == low ? 0 : 3) = sign * one;
      }
      sign = -1.0;
    }
    const Eigen::Matrix<double, 6, 6> springs = stiffness * both.transpose() * both;
    for (const int b : {low, high})
      for (const int other : {low, high})
        all.block<3, 3>(3 * b, 3 * other) +=
            springs.block<3, 3>(b == low ? 0 : 3, other == low ? 0 : 3);
  }
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Matrix>(all, Eigen::EigenvaluesOnly)
                       .eigenvalues()
                       .maxCoeff());
}

/// Rock cut by these cards between three fixed blocks, 1500 steps after gravity began.
Model settling_rock(const std::string& cuts, int seed) {
  const TemporaryFolder folder;
  std::string deck = preliminary(fmt::format("SEED, {}\nRIGID\n", seed));
  const auto replace = [&](const std::string& old, const std::string& now) {
    deck.replace(deck.find(old), old.size(), now);
  };
  replace("100, 6", "900, 30");
  replace("0.1\nSTIFF, 1.E7, 1.E7\nFRACTION, 0.02",
          "0.001\nSTIFF, 1.E9, 1.E9\nFRACTION");
  run_text(folder, "a",
           deck + rectangle(-3, -1, 3, 0, true) + rectangle(-3, 0, -2, 2, true) +
               rectangle(2, 0, 3, 2, true) +
               "OUTLINE, 4, 1\n-2, -2, 2, 2\n0, 2, 2, 0\n" + cuts +
               "GRAVITY, 5, -9.81\nFRICTN, .7\nLOCDAMP, .8\nCYCLE, 1500\nSTOP\n");
  output::CheckpointInfo info;
  return output::read_checkpoint((folder / "a.ckpt.h5").string(), info);
}

struct Cut {
  const char *name, *cards;
};
class SafeStep : public ::testing::TestWithParam<Cut> {};

TEST_P(SafeStep, IsStableForTheContactsOfPackedRock) {
  double nearest = 0.0;
  for (int seed = 1; seed <= 6; ++seed) {
    const Model model = settling_rock(GetParam().cards, seed);
    ASSERT_GT(model.contacts.size(), 100U);
    const double limit = 2.0 / highest_frequency(model) / std::sqrt(1.0 + alpha);
    EXPECT_LT(model.time_step.dt, limit) << "seed " << seed;
    nearest = std::max(nearest, model.time_step.dt / limit);
  }
  EXPECT_GT(nearest, 0.6) << "the step is smaller than it need be";
}

INSTANTIATE_TEST_SUITE_P(
    Rock, SafeStep,
    ::testing::Values(
        Cut{"Cells", "VORONOI, 90\nCUT\n"}, Cut{"EvenCells", "VORONOI, 90, 20\nCUT\n"},
        Cut{"TwoSets", "JSET, 1, 10, 3, .25, .05\nJSET, 2, 80, 4, .4, .1\nCUT\n"},
        Cut{"Beds", "JSET, 1, 5, 2, .25, .05\n"
                    "JSET, 2, 95, 3, .4, .1, .7, 0, 0, 0, , , UNIFORM, 1\nCUT\n"},
        Cut{"Triangles", "JSET, 1, 0, 0, .3\nJSET, 2, 60, 0, .3\nJSET, 3, 120, 0, "
                         ".3\nCUT, .02, .02\n"}),
    [](const auto& cut) { return std::string(cut.param.name); });

}  // namespace
}  // namespace blocks::testing
