// INSITU: the stress in the ground balances gravity from the first step on, and springs
// with offsets neither vanish nor depend on how the run is made.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "model/equilibrium.hpp"
#include "output/checkpoint.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string frame = rectangle(-1, -1, 9, 0, true) + rectangle(-1, 0, 0, 8, true) +
                          rectangle(8, 0, 9, 8, true);
const std::string outline = "OUTLINE, 4, 1\n0, 0, 8, 8\n0, 8, 8, 0\n";
const std::string voronoi = frame + outline + "VORONOI, 30, 2, 5\nCUT, .1, .05\n";
/// Layers of merged, oriented random blocks, with T-junctions.
const std::string layers = frame + "ORIENT, -15, 15\nMERGE, .4\n"
                                   "LAYER, -6, 1, 0,0, 0,2, 8,2, 8,0, RANDOM\n"
                                   "LAYER, -6, 1, 0,2, 0,5, 8,5, 8,2, RANDOM\n"
                                   "LAYER, -6, 1, 0,5, 0,8, 8,8, 8,5, RANDOM\n";
/// Two sets of joints, whose blocks need not be convex.
const std::string joints = frame + outline +
                           "JSET, 1, 30, 5, 1.5, .3, 6, 2, .5, .2\n"
                           "JSET, 2, 110, 8, 1.5, .4, 5, 2, 1, .3\nCUT, .05, .01\n";

/// Density 1000, gravity 10, depth 8: 80 kPa at the bottom. K0 is .5.
const std::string stress = "GRAVITY, 0, -10\nFRICTN, .7\n"
                           "INSITU, -4.E4, -8.E4, 0, 5.E3, 1.E4\n";

class InSitu : public ::testing::Test {
 protected:
  /// Runs the cards after the preliminary ones of a rigid or deformable problem.
  Model ran(const std::string& cards, bool rigid = true, const std::string& more = {}) {
    std::string first =
        preliminary(std::string("FUNCTION, 1\n0, 1\n") + (rigid ? "RIGID\n" : ""));
    first.replace(first.find("100, 6"), 6, "300, 40");
    outcome_ = run_text(folder_, "ground", first + cards + "STOP\n", more);
    output::CheckpointInfo info;
    return output::read_checkpoint((folder_ / "ground.ckpt.h5").string(), info);
  }
  TemporaryFolder folder_;
  Outcome outcome_;
};

TEST_F(InSitu, BalancesGravityOnEveryTiling) {
  for (const std::string& blocks : {voronoi, layers, joints})
    for (const bool rigid : {true, false})
      for (const int steps : {1, 500}) {
        const Model model =
            ran(blocks + stress + fmt::format("CYCLE, {}\n", steps), rigid);
        EXPECT_LE(unbalanced_ratio(model), 1e-12) << blocks << rigid << steps;
        EXPECT_THAT(outcome_.err, Not(HasSubstr("warning: INSITU")));
      }
}

TEST_F(InSitu, BalancesWithEveryLaw) {
  const std::string pairs = "JPAIR, 1, 1, 7\n";
  for (const std::string& law :
       {"JOINT, 7, .7, , , , , , 5, .01, 1.E9, 5.E8\n" + pairs,
        "JOINT, 7, .7, 1.E5, 5.E4, , , , , , 1.E9, 5.E8\n" + pairs + "BOND, 7\n",
        "JOINT, 7, .7, , , , , , , , 1.E9, 5.E8\nWALTON, 7, .5\n" + pairs,
        "JOINT, 7, , , , , , , , , , 5.E8\n"
        "BARTON, 7, 10, 1.E8, 30, 1.E-3, 1.E9, 5.E-3, 1.E10\n" +
            pairs}) {
    // Barton's joints slip from the beginning under shear, so the stress is isotropic.
    const bool is_barton = law.find("BARTON") != law.npos;
    const std::string at_rest = is_barton ? "GRAVITY, 0, -10\nFRICTN, .7\n"
                                            "INSITU, -8.E4, -8.E4, 0, 1.E4, 1.E4\n"
                                          : stress;
    const Model model = ran(voronoi + law + at_rest + "CYCLE, 300\n");
    EXPECT_LE(unbalanced_ratio(model), 1e-12) << law;
  }
}

TEST_F(InSitu, PutsItsStressIntoDeformableBlocks) {
  const Model model = ran(layers + stress + "CYCLE, 1\n", false);
  for (int b = 0; b < model.blocks.size(); ++b) {
    const double y = model.blocks.centroid(1, b);
    EXPECT_NEAR(model.blocks.stress(0, b), -4e4 + 5e3 * y, 1e-6);
    EXPECT_NEAR(model.blocks.stress(3, b), -8e4 + 1e4 * y, 1e-6);
  }
}

// The second card replaces the springs of the first. Without stress nothing is left.
TEST_F(InSitu, IsReplacedByTheNextCard) {
  const std::string twice = "INSITU, -1.E6, -2.E6, 1.E5\n" + stress + "CYCLE, 1\n";
  EXPECT_LE(unbalanced_ratio(ran(voronoi + twice)), 1e-12);
  const Model none =
      ran(voronoi + "FRICTN, .7\nINSITU, -1.E4, -1.E4\nINSITU\nCYCLE, 1\n");
  EXPECT_TRUE(none.contacts.empty());
}

// PRESSBC is positive inwards, INSITU in tension. The pressures are those of the
// stress.
TEST_F(InSitu, AgreesWithPressures) {
  const std::string cards = rectangle(-1, -1, 3, 0, true) + rectangle(0, 0, 2, 1) +
                            "PRESSBC, 2, 1, 1.E4, 5.E3\nPRESSBC, 2, 2, 1.E4, 1.E4\n"
                            "PRESSBC, 2, 3, 5.E3, 1.E4\nGRAVITY, 0, -10\nFRICTN, .7\n"
                            "INSITU, -1.E4, -2.E4, 0, 5.E3, 1.E4\n";
  for (const bool rigid : {true, false}) {
    EXPECT_LE(unbalanced_ratio(ran(cards + "CYCLE, 1\n", rigid)), 1e-12);
    EXPECT_LE(unbalanced_ratio(ran(cards + "CYCLE, 500\n", rigid)), 1e-12);
  }
}

// A removed block disturbs its neighbours. Coincident corners part and swap places, and
// pass on their springs: the run with threads and other instructions, and the restarted
// one, end in the same state. The audit knows all these contacts.
TEST_F(InSitu, HasTheSameBitsInEveryRun) {
  for (const std::string& blocks : {voronoi, layers}) {
    const std::string cards =
        blocks + "DAMPING, .2\n" + stress + "CYCLE, 20\nREMOVE, 12\n";
    const auto hash = [&] { return summary(folder_, "ground")["state_hash"]; };
    ran(cards + "CYCLE, 300\nCYCLE, 300\n", true, "--audit=20 -j 2");
    EXPECT_THAT(outcome_.out + outcome_.err, HasSubstr("wrong decisions: 0"));
    const auto whole = hash();
    ::setenv("BLOCKS_SIMD", "baseline", 1);
    ran(cards + "CYCLE, 300\nCYCLE, 300\n", true, "-j 1");
    ::unsetenv("BLOCKS_SIMD");
    EXPECT_EQ(hash(), whole);
    ran(cards + "CYCLE, 300\n", true, "-j 1");
    run_text(folder_, "rest", "RESTART\nCYCLE, 300\nSTOP\n", "-o ground");
    EXPECT_EQ(hash(), whole);
  }
}

// Corners that coincide at first part and swap places. Their springs stay.
TEST_F(InSitu, KeepsItsForcesWhenCornersPart) {
  ran(voronoi + "DAMPING, .2\nHISTORY, .01, energy:residual\n" + stress +
      "CYCLE, 20\nREMOVE, 12\nCYCLE, 2000\n");
  const auto energy = summary(folder_, "ground")["energy"];
  const double start = energy["start"];
  EXPECT_LT(std::abs(energy["transfer"].get<double>()), 1e-3 * start);
  EXPECT_LT(std::abs(energy["residual"].get<double>()), 1e-9 * start);
}

TEST_F(InSitu, CountsItsSpringsAsRemovedEnergy) {
  ran(voronoi + "HISTORY, .001, energy:removed\nCYCLE, 1\n" + stress + "CYCLE, 1\n");
  const auto energy = summary(folder_, "ground")["energy"];
  EXPECT_LT(energy["removed"].get<double>(), 0.0);
  EXPECT_LT(std::abs(energy["residual"].get<double>()),
            1e-9 * energy["at_play"].get<double>());
}

TEST_F(InSitu, WarnsWhereTheStressCannotBeCarried) {
  ran(voronoi + "FRICTN, .1\nINSITU, -1.E4, -9.E4\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("cannot carry the stress and will slip or fail"));
  ran(voronoi + "FRICTN, .5\nINSITU, 1.E4, 1.E4\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("without tensile strength would be in tension"));
  ran(rectangle(0, 0, 1, 1) + rectangle(3, 0, 4, 1) + "INSITU, -1\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("no faces are flush within"));
  ran(rectangle(0, 0, 1, 1) + rectangle(1, 0, 2, 1) +
      "SPLANE, 0, 2, 0, -2\nINSITU, -1\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("sides on a symmetry plane are not loaded"));
}

TEST_F(InSitu, TellsHowManyFacesItLoads) {
  ran(frame + rectangle(0, 0, 8, 8) + "FRICTN, .7\nINSITU, -1.E4, -1.E4\nCYCLE, 1\n");
  const Outcome check = blocks("check ground.deck", folder_.path());
  EXPECT_THAT(check.out, HasSubstr("3 faces loaded"));
}

}  // namespace
}  // namespace blocks::testing
