// JOINT, WALTON, BARTON, JPAIR, BOND and DRIVE: what the cards set, and what the
// program tells about it. Wrong input is in corpus/bad_cards and corpus/bad_run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_reader.hpp"
#include "run/run.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string two_boxes = rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 2, 1);

class LawCards : public ::testing::Test {
 protected:
  /// Builds the model of these cards. The messages are in `said_`.
  Model built(const std::string& cards) {
    folder_.write("laws.deck", preliminary() + cards + two_boxes + "CYCLE, 1\n");
    run::RunOptions options;
    options.deck = (folder_ / "laws.deck").string();
    ::testing::internal::CaptureStderr();
    run::CheckedDeck checked = run::build_checked(options);
    said_ = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(checked.code, run::done) << said_;
    return std::move(checked.model);
  }
  TemporaryFolder folder_;
  std::string said_;
};

TEST_F(LawCards, JointHasDefaults) {
  const JointLaw bare = built("JOINT, 3, .5\n").settings.joint_laws.at(3);
  JointLaw expected;
  expected.friction = expected.residual_friction = 0.5;
  EXPECT_EQ(bare, expected);
  const JointLaw stiff =
      built("JOINT, 3, .5, , , .25, , , , , 1e9\n").settings.joint_laws.at(3);
  expected.residual_friction = 0.25;
  expected.normal_stiffness = expected.shear_stiffness = 1e9;
  EXPECT_EQ(stiff, expected);
}

TEST_F(LawCards, JointTakesAllItsValues) {
  const JointLaw law = built("JOINT, 1000000000, 1.5, 2e5, 1e5, 1.25, 3e4, 2e4, 45,\n"
                             ".005, 1e9, 2e9\n")
                           .settings.joint_laws.at(1000000000);
  JointLaw expected;
  expected.friction = 1.5, expected.residual_friction = 1.25;
  expected.cohesion = 2e5, expected.residual_cohesion = 3e4;
  expected.tension = 1e5, expected.residual_tension = 2e4;
  expected.dilation = 1.0, expected.dilation_limit = 0.005;
  expected.normal_stiffness = 1e9, expected.shear_stiffness = 2e9;
  EXPECT_EQ(law, expected);
  EXPECT_THAT(said_, HasSubstr("no BOND card bonds joint id 1000000000"));
}

// The residual tension is lowered because the peak is, and a second time by its own
// apex.
TEST_F(LawCards, TensionIsLoweredToTheApexOfTheStrength) {
  const JointLaw law =
      built("JOINT, 3, .5, 1e5, 3e5, .25, 2e4, 3e5\n").settings.joint_laws.at(3);
  EXPECT_EQ(law.tension, 2e5);
  EXPECT_EQ(law.residual_tension, 8e4);
  EXPECT_THAT(said_, HasSubstr("deck:12:20: warning: JOINT: ten = 300000 is lowered to "
                               "coh / fric = 200000"));
  EXPECT_THAT(said_,
              HasSubstr("deck:12:35: warning: JOINT: tenr = 200000 is lowered to "
                        "cohr / fricr = 80000"));
  EXPECT_EQ(built("JOINT, 3, 0, 0, 3e5\n").settings.joint_laws.at(3).tension, 3e5);
  EXPECT_THAT(said_, Not(HasSubstr("is lowered")));
}

TEST_F(LawCards, WaltonAndBartonExtendAJoint) {
  const Model model = built("JOINT, 3, .5, 1e4, , , , , , , 1e9\nWALTON, 3, .25\n"
                            "JOINT, 4, , , , , , , , , , 2e9\n"
                            "BARTON, 4, 10, 1e8, 30, .004, 1e10, 2e-4, 1e12\n");
  const JointLaw& walton = model.settings.joint_laws.at(3);
  EXPECT_EQ(walton.kind, LawKind::walton);
  EXPECT_EQ(walton.restitution, 0.25);
  EXPECT_EQ(walton.cohesion, 1e4);
  EXPECT_EQ(walton.normal_stiffness, 1e9);
  JointLaw expected;
  expected.kind = LawKind::barton;
  expected.shear_stiffness = 2e9;
  expected.roughness = 10, expected.wall_strength = 1e8, expected.residual_angle = 30;
  expected.peak_slip = 0.004, expected.initial_stiffness = 1e10;
  expected.largest_closure = 2e-4, expected.largest_stiffness = 1e12;
  EXPECT_EQ(model.settings.joint_laws.at(4), expected);
}

TEST_F(LawCards, JpairTakesMaterialsInEitherOrder) {
  const Model model = built("JOINT, 3\nJOINT, 4\nJPAIR, 2, 1, 3\nJPAIR, 2, 2, 4\n");
  EXPECT_EQ(model.settings.joint_of_materials,
            (std::map<std::pair<int, int>, int>{{{1, 2}, 3}, {{2, 2}, 4}}));
}

// A pair and the values of a joint may change after a motion.
TEST_F(LawCards, JointAndJpairMayChangeAfterAMotion) {
  run_text(folder_, "laws",
           preliminary() + two_boxes +
               "JOINT, 3, .5\nJOINT, 4\nJPAIR, 1, 1, 3\n"
               "CYCLE, 1\nJOINT, 3, .25\nJPAIR, 1, 1, 4\n"
               "CYCLE, 1\n");
  output::CheckpointInfo info;
  const Model model =
      output::read_checkpoint((folder_ / "laws.ckpt.h5").string(), info);
  EXPECT_EQ(model.settings.joint_laws.at(3).friction, 0.25);
  EXPECT_EQ(model.settings.joint_of_materials.at({1, 1}), 4);
}

// Faults of a JOINT or MATERIAL card cause no errors of cards that name it.
TEST_F(LawCards, UnreadCardsCauseNoFurtherErrors) {
  folder_.write("laws.deck", preliminary() +
                                 "JOINT, 3, -.5\nWALTON, 3, .5\nJPAIR, 1, 1, 3\n"
                                 "BOND, 3\nBOND\n");
  const Outcome outcome = blocks("check laws.deck", folder_.path());
  EXPECT_EQ(outcome.code, run::deck_error);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("JOINT: fric must be >= 0"), HasSubstr("1 error\n")));
}

TEST_F(LawCards, CheckAndListingTellWhichLawActsWhere) {
  folder_.write("laws.deck", preliminary() + two_boxes +
                                 "JOINT, 3, .5, 2e5, 1e5, .4, , , 10, .01, 1e9\n"
                                 "JOINT, 4, .5\nWALTON, 4, .5\nJOINT, 5\n"
                                 "BARTON, 5, 10, 1e8, 30, .004, 1e10, 2e-4, 1e12\n"
                                 "JPAIR, 2, 1, 3\nJPAIR, 1, 1, 5\nFRICTN, .3\n"
                                 "DRIVE, 1, .5, 0, .25\nCYCLE, 1\n");
  const std::string laws =
      "joint 3: Mohr-Coulomb, fric 0.5, coh 200000, ten 100000; residual fric 0.4, coh "
      "0, ten 0; tan(dil) 0.176327 up to a slip of 0.01; kn 1e+09 per area, ks 1e+09 "
      "per area\n"
      "joint 3 acts between materials 1 and 2\n"
      "joint 4: Walton, restitution 0.5, fric 0.5, coh 0, ten 0; residual fric 0.5, "
      "coh "
      "0, ten 0; Kn of STIFF, Ks of STIFF\n"
      "joint 4 acts nowhere: no side has this id, and no JPAIR card names it\n"
      "joint 5: Barton-Bandis, JRC 10, JCS 1e+08, phir 30 degrees, upeak 0.004; kni "
      "1e+10, vm 0.0002, knmax 1e+12; Ks of STIFF\n"
      "joint 5 acts between materials 1 and 1\n"
      "all other contacts: FRICTN 0.3, STIFF 1e+07, 1e+07\n"
      "block 1 is driven: velocity (0.5, 0), spin 0.25\n";
  EXPECT_THAT(blocks("check laws.deck", folder_.path()).out, HasSubstr(laws));
  ASSERT_EQ(blocks("run laws.deck", folder_.path()).code, 0);
  EXPECT_THAT(slurp(folder_ / "laws.out"), HasSubstr(laws));
}

TEST_F(LawCards, DriveMovesAFixedBlockUntilTheNextCard) {
  run_text(folder_, "belt",
           preliminary() + two_boxes +
               "FRICTN, .5\nGRAVITY, 0, -10\n"
               "DRIVE, 1, .5\nMOTION, .5\nDRIVE, 1\n"
               "MOTION, .25\nDRIVE, 1, 0, 0, .1\nCYCLE, 10\n"
               "FIX, 1\nCYCLE, 10\n");
  post::ResultsReader results((folder_ / "belt.vtkhdf").string());
  const post::Frame last = results.frame(results.frames() - 1);
  const double dt = summary(folder_, "belt")["dt"]["value"];
  EXPECT_NEAR(last.centroid(0, 0), 0.25, 0.5 * dt + 1e-12);
  EXPECT_EQ(last.velocity.col(0), Eigen::Vector2d(0, 0));
  EXPECT_NEAR(last.angle[0], 10 * dt * 0.1, 1e-15);
  EXPECT_EQ(last.spin[0], 0.0);
  EXPECT_EQ(last.fixed[0], 1);
}

// The run stops while a block is driven, between two drives and at a card.
TEST_F(LawCards, RunWithDrivesAndLawsIsResumedToTheBit) {
  const std::string deck =
      preliminary() + two_boxes + rectangle(-4, 0, -1, 1, true) +
      "GRAVITY, 0, -10\nDAMPING, .2\nJOINT, 3, .5, 1e5, 1e5, .4, , , 10, .01, 1e8\n"
      "JPAIR, 1, 1, 3\nBOND\nDRIVE, 3, .5\nPLOTS, .05\nHISTORY, .01, fx:3, x:2\n"
      "MOTION, .2\nJOINT, 3, .4\nDRIVE, 3, 0, .5, 1\nMOTION, .1\nDRIVE, 3\nMOTION, "
      ".1\n";
  TemporaryFolder parts;
  run_text(folder_, "laws", deck);
  parts.write("laws.deck", deck);
  std::string restart;
  for (const char* stop : {"77", "201", "33", "400"}) {
    ASSERT_EQ(
        blocks("run laws.deck" + restart + " --stop-after " + stop, parts.path()).code,
        75);
    restart = " --restart laws.ckpt.h5";
  }
  ASSERT_EQ(blocks("run laws.deck" + restart, parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "laws"), left_by_run(folder_.path(), "laws"),
              "stops");
}

}  // namespace
}  // namespace blocks::testing
