// What runs with laws of joints write and tell: results, histories, why, audit,
// summary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// A block 2 wide and 1 high, weight 2e4, hangs below the fixed block 1. Block 3 is
/// beside block 1, and joint 2 is between their materials.
const std::string hanging =
    preliminary() + rectangle(-1, 1, 1, 2, true) + rectangle(-1, 0, 1, 1) +
    "JOINT, 1, 0.5, 1.E5, 5.E4\nJPAIR, 1, 1, 1\nBOND, 1\nGRAVITY, 0, -10\n"
    "DAMPING, 0.5\nPLOTS, 0.1\nHISTORY, 0.1, bonded, normal_stress:joint=1\n";

/// The last value of a curve.
double last_value(const TemporaryFolder& folder, const std::string& curve) {
  const Outcome answer =
      blocks("history a.vtkhdf --frames --csv -q " + curve, folder.path());
  EXPECT_EQ(answer.code, 0) << answer.err;
  const auto line = answer.out.rfind('\n', answer.out.size() - 2);
  return std::stod(answer.out.substr(answer.out.find(',', line) + 1));
}

TEST(JointLawOutput, OfABondThatHolds) {
  const TemporaryFolder folder;
  run_text(folder, "a", hanging + "MOTION, 1\nSTOP\n", "--audit=10");
  EXPECT_EQ(last_value(folder, "bonded"), 4.0);
  EXPECT_EQ(last_value(folder, "failed"), 0.0);
  EXPECT_NEAR(last_value(folder, "normal_stress:1+2"), -1e4, 100.0) << "tension";
  EXPECT_NEAR(last_value(folder, "joint_length:joint=1"), 2.0, 1e-12);
  const Json told = summary(folder, "a");
  EXPECT_EQ(told["joint_contacts"],
            Json({{"with_law", 4}, {"bonded", 4}, {"failed", 0}, {"broken", 0}}));
  EXPECT_EQ(told["audit"]["wrong_decisions"], 0);
  for (const char* file : {"a.vtkhdf", "a.ckpt.h5"}) {
    const Outcome why =
        blocks(std::string("why ") + file + " -b 1 -b 2", folder.path());
    EXPECT_THAT(why.out, HasSubstr("law of joint 1: bonded, slip "));
    EXPECT_THAT(why.out, HasSubstr("whatever the rule decides"));
    const Outcome json =
        blocks(std::string("why --json ") + file + " -b 1 -b 2", folder.path());
    EXPECT_EQ(Json::parse(json.out)["step_before"][0]["law"]["bond"], "bonded");
  }
}

TEST(JointLawOutput, IsExportedWithTheContacts) {
  const TemporaryFolder folder;
  run_text(folder, "a", hanging + "MOTION, 0.1\nSTOP\n");
  ASSERT_EQ(blocks("export a.vtkhdf -o a.csv", folder.path()).code, 0);
  const std::string text = slurp(folder / "a_contacts.csv");
  EXPECT_THAT(text, HasSubstr("overlap,joint,bond,normal_stiffness,shear_stiffness,"
                              "slip,slip_path,closure,plastic_closure,dilation,"
                              "bonded,failed,length\n"));
  EXPECT_THAT(text, HasSubstr(",1,bonded,10000000,10000000,0,0,0,0,0,1,0,0.5\n"));
  ASSERT_EQ(blocks("export a.vtkhdf -o a.pvd", folder.path()).code, 0);
}

TEST(JointLawOutput, OfABondThatBreaks) {
  const TemporaryFolder folder;
  std::string deck = hanging;
  deck.replace(deck.find("5.E4"), 4, "5.E3");
  const Outcome run = run_text(folder, "a", deck + "MOTION, 0.3\nSTOP\n", "--audit=10");
  EXPECT_EQ(last_value(folder, "bonded"), 0.0);
  EXPECT_EQ(summary(folder, "a")["joint_contacts"]["broken"], 4);
  EXPECT_EQ(summary(folder, "a")["audit"]["wrong_decisions"], 0);
  EXPECT_THAT(run.err, HasSubstr("4 of 4 bonds broken"));
}

TEST(JointLawOutput, HistoriesOfJointsNeedALaw) {
  const TemporaryFolder folder;
  const std::string bare = preliminary() + rectangle(-1, 0, 1, 1) + "GRAVITY, 0, -10\n";
  folder.write("b.deck", bare + "HISTORY, 0.1, slip:joint=1\nMOTION, 0.1\nSTOP\n");
  const Outcome check = blocks("check b.deck", folder.path());
  EXPECT_EQ(check.code, 3);
  EXPECT_THAT(check.err, HasSubstr("HISTORY: slip:joint=1 needs a joint with a law"));
  folder.write("c.deck", hanging + "HISTORY, 0.1, slip:joint=3\nMOTION, 0.1\nSTOP\n");
  EXPECT_THAT(blocks("check c.deck", folder.path()).err,
              HasSubstr("no JOINT card above has the id 3"));
  run_text(folder, "a", bare + "MOTION, 0.1\nSTOP\n");
  const Outcome history = blocks("history a.vtkhdf -q slip", folder.path());
  EXPECT_NE(history.code, 0);
  EXPECT_THAT(history.err, HasSubstr("a.vtkhdf has no joints with a law"));
  EXPECT_FALSE(summary(folder, "a").contains("joint_contacts"));
}

}  // namespace
}  // namespace blocks::testing
