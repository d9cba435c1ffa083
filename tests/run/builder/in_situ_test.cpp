// INSITU: the stress in the ground balances gravity from the first step on, and springs
// with offsets neither vanish nor depend on how the run is made.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "model/equilibrium.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "tools/program.hpp"

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
      "SPLANE, 0, 2, 0, -2\nINSITU, -1, , .1\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("2 corners on symmetry planes would bear shear"));
}

// The outside is a floor and symmetry planes, upright, slanted or both.
TEST_F(InSitu, LoadsSidesOnSymmetryPlanes) {
  const std::string floor = rectangle(-1, -1, 9, 0, true);
  const std::string planes = "SPLANE, 0, 9, 0, 0\nSPLANE, 8, 0, 8, 9\n";
  for (const std::string& inside :
       {outline + "VORONOI, 30, 2, 5\nCUT, .1, .05\n",
        std::string("LAYER, -6, 1, 0,0, 0,2, 8,2, 8,0, RANDOM\n"
                    "LAYER, -6, 1, 0,2, 0,8, 8,8, 8,2, RANDOM\n")})
    for (const bool rigid : {true, false})
      for (const int steps : {1, 500}) {
        const Model model =
            ran(floor + inside + planes + stress + fmt::format("CYCLE, {}\n", steps),
                rigid);
        EXPECT_LE(unbalanced_ratio(model), 1e-12) << inside << rigid << steps;
        EXPECT_THAT(outcome_.err, Not(HasSubstr("warning: INSITU")));
        double on_planes = 0.0;
        for (const PlaneContact& contact : model.plane_contacts)
          on_planes += contact.normal_force;
        // The mean of sxx is -2e4 over a height of 8, on both planes.
        EXPECT_NEAR(on_planes, 2 * 8 * 2e4, 1e-9 * on_planes) << inside << rigid;
      }
}

// A plane has no friction: the ground must not have shear there.
TEST_F(InSitu, KeepsPlanesWhenThePlaneComesFirst) {
  ran(rectangle(0, 0, 1, 1) + rectangle(1, 0, 2, 1) +
      "INSITU, -1\nSPLANE, 0, 2, 0, -2\nCYCLE, 1\n");
  EXPECT_THAT(outcome_.err, HasSubstr("INSITU has not loaded the sides on this plane"));
}

// Two rows of fixed blocks bear the ground. The lower one is free later, and stays at
// rest.
TEST_F(InSitu, LoadsFacesBetweenFixedBlocksWhenTheyAreFreed) {
  std::string rows;
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 8; ++i)
      rows += rectangle(i, -row - 1, i + 1, -row, true);
  const std::string walls =
      rectangle(-1, -3, 0, 8, true) + rectangle(8, -3, 9, 8, true);
  for (const bool rigid : {true, false})
    for (const std::string until : {"", "CYCLE, 100\n"}) {
      const Model model = ran(rows + walls + rectangle(-1, -4, 9, -3, true) + outline +
                                  "VORONOI, 30, 2, 5\nCUT, .1, .05\n" + stress + until +
                                  "FREE, in(0, -2, 8, 0)\nCYCLE, 200\n",
                              rigid);
      EXPECT_LE(unbalanced_ratio(model), 1e-12) << rigid << until;
    }
}

// All blocks are fixed when INSITU acts, so it loads nothing but remembers its field.
TEST_F(InSitu, LoadsBlocksThatWereAllFixed) {
  for (const bool rigid : {true, false}) {
    const Model model =
        ran(rectangle(0, 0, 1, 1, true) + rectangle(1, 0, 2, 1, true) +
                rectangle(-1, 0, 0, 1, true) + rectangle(2, 0, 3, 1, true) +
                "INSITU, -1.E5\nFREE, 1, 2\nCYCLE, 100\n",
            rigid);
    EXPECT_LE(unbalanced_ratio(model), 1e-12) << rigid;
    ASSERT_FALSE(model.contacts.empty());
    for (const Contact& contact : model.contacts)
      EXPECT_NEAR(contact.normal_elastic, 25e3, 1e-6);
  }
}

// In a turned frame the principal stresses have shear of rounding only.
TEST_F(InSitu, DoesNotWarnOfRounding) {
  std::string blocks;
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (int i = -1; i < 2; ++i)
    for (int j = -1; j < 2; ++j) {
      std::string xs, ys;
      for (const auto& [x, y] : {std::pair(i, j), std::pair(i, j + 1),
                                 std::pair(i + 1, j + 1), std::pair(i + 1, j)}) {
        xs += fmt::format("{}{:.17g}", xs.empty() ? "" : ", ", c * x - s * y);
        ys += fmt::format("{}{:.17g}", ys.empty() ? "" : ", ", s * x + c * y);
      }
      blocks +=
          fmt::format("CREATE, 4, 1, {}\n{}\n{}\n", i != 0 || j != 0 ? 1 : 0, xs, ys);
    }
  const double mean = -7.5e4, half = -2.5e4;  // -1e5 and -5e4 along the sides
  ran(blocks + fmt::format("INSITU, {:.17g}, {:.17g}, {:.17g}\nCYCLE, 1\n",
                           mean + half * std::cos(1.4), mean - half * std::cos(1.4),
                           half * std::sin(1.4)));
  EXPECT_THAT(outcome_.err, Not(HasSubstr("warning: INSITU")));
}

// Shear in the ground has mobilised the roughness of a joint of BARTON.
TEST_F(InSitu, MobilisesTheStrengthOfBarton) {
  const std::string barton = "JOINT, 7, , , , , , , , , , 5.E8\n"
                             "BARTON, 7, 10, 1.E8, 30, 1.E-3, 1.E9, 5.E-3, 1.E10\n"
                             "JPAIR, 1, 1, 7\n";
  const Model model = ran(voronoi + barton + stress + "CYCLE, 300\n");
  EXPECT_THAT(outcome_.err, Not(HasSubstr("cannot carry")));
  EXPECT_LE(unbalanced_ratio(model), 1e-12);
  double path = 0.0;
  for (const LawState& state : model.law_states) {
    path = std::max(path, state.path);
    EXPECT_NEAR(state.slip, 0.0, 1e-15);
  }
  EXPECT_GT(path, 1e-4);
  EXPECT_LT(path, 1e-3);
}

TEST_F(InSitu, TellsHowManyFacesItLoads) {
  ran(frame + rectangle(0, 0, 8, 8) + "FRICTN, .7\nINSITU, -1.E4, -1.E4\nCYCLE, 1\n");
  const Outcome check = blocks("check ground.deck", folder_.path());
  EXPECT_THAT(check.out, HasSubstr("3 faces loaded"));
}

}  // namespace
}  // namespace blocks::testing
