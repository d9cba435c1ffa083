// A corner at a joint of a floor or wall moves as on a floor or wall of one block.
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

/// Returns the preliminary cards with a stiffness in N/m.
std::string cards(const std::string& stiffness, const std::string& fraction) {
  return "START, 20, 4\nTOE\nXLIMITS, -60, 60\nYLIMITS, -60, 60\nBOXES, 40, 40, 0.05\n"
         "STIFF, " +
         stiffness + ", " + stiffness + "\nFRACTION, " + fraction +
         "\nMATERIAL, 1, 1.E9, 4.E8, 2000\nRIGID\nEND\n";
}

// A frictionless triangle leans against a wall, and its lowest corner is exactly at a
// joint of the floor. The overlaps are below and above the slack. In the first step,
// before anything overlaps, the joint may absorb a little energy.
TEST(ClosedJoint, DoesNotHoldAPropThatSlips) {
  const std::string wall_and_prop =
      rectangle(0.3, 0.2, 1, 1, true) +
      "CREATE, 3, 1\n0, -0.02, 0.3\n0, 0.3, 0.5\nGRAVITY, 0, -10\nFRICTN, 0\n"
      "DAMPING, 0.3\nMOTION, 0.4\nSTOP\n";
  for (const char* const stiffness : {"1.E7", "1.E8", "1.E9"}) {
    const TemporaryFolder folder;
    run_text(folder, "joints",
             cards(stiffness, "0.02") + rectangle(-2, -1, 0, 0, true) +
                 rectangle(0, -1, 2, 0, true) + wall_and_prop);
    run_text(folder, "one",
             cards(stiffness, "0.02") + rectangle(-2, -1, 2, 0, true) + wall_and_prop);
    const double energy = summary(folder, "one")["kinetic_energy"];
    EXPECT_GT(energy, 10.0);
    EXPECT_NEAR(summary(folder, "joints")["kinetic_energy"], energy, 0.25 * energy)
        << stiffness;
  }
}

// A bar is flush with a wall beside a joint and turns. The two ends of its side enter
// the joint one after the other.
TEST(ClosedJoint, IsDecidedExactlyWhileABarTurns) {
  for (const char* const spin : {"5", "10"}) {
    const TemporaryFolder folder;
    run_text(folder, "bar",
             cards("1.E6", "0.01") + rectangle(0, 0.05, 1, 1.05, true) +
                 rectangle(0, -0.95, 1, 0.05, true) + rectangle(-0.1, 0, 0, 0.5) +
                 "SETVEL, 3, , " + std::to_string(0.1 * std::stod(spin)) + ", 0, " +
                 spin + "\nDAMPING, 0.1\nMOTION, 0.006\nSTOP\n",
             "--audit=1");
    EXPECT_EQ(summary(folder, "bar")["audit"]["wrong_decisions"], 0) << spin;
  }
}

/// Cards of a slow run in a large domain.
std::string slow_cards(const std::string& right_end) {
  return "START, 10, 10\nSLOW\nXLIMITS, -50, " + right_end +
         "\nYLIMITS, -50, 50\nBOXES, 20, 20, .02\nSTIFF, 1.E7, 1.E7\nFRACTION, .01\n"
         "MATERIAL, 1, 1.E10, 4.E9, 1.E9\nRIGID\nEND\n";
}

/// Returns the number of wrong decisions in a run that audits every step.
long wrong_decisions(const std::string& deck) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  blocks("run a.deck --audit=1", folder.path());
  return summary(folder, "a")["audit"]["wrong_decisions"];
}

// Two blocks have no neighbour until a driven one comes from below. It hides a side of
// the corner on which the upper block stands.
TEST(ClosedJoint, IsSeenWhenAThirdBlockComes) {
  EXPECT_EQ(wrong_decisions(slow_cards("50") +
                            "CREATE, 4, 1, 1\n-2, -2, 0, 0\n-2, 0, 0, -2\n"
                            "CREATE, 4, 1, 0\n-.005, -.005, 1, 1\n-.02, 1, 1, -.02\n"
                            "CREATE, 4, 1, 1\n1, 1, 3, 3\n-3, -1, -1, -3\n"
                            "DRIVE, 3, -.005, .005, 0\nPLOTS, 5\nMOTION, 202\nSTOP\n"),
            0);
}

// The third block leaves the domain and becomes fixed, as the first one is, so it is a
// third part no more.
TEST(ClosedJoint, OpensWhenAThirdBlockIsFixed) {
  EXPECT_EQ(
      wrong_decisions(slow_cards("1.0003") +
                      "CREATE, 3, 1, 1\n-1, .003, 1\n-1, .02, -1\n"
                      "CREATE, 4, 1, 0\n-1, -1, 0, 0\n0, 1, 1, 0\n"
                      "CREATE, 4, 1, 0\n0, 0, 1, 1\n0, 1, 1, 0\n"
                      "SETVEL, 3, 0, .0001, 0, 0\nSETVEL, 2, 0, -.00000001, 0, 0\n"
                      "CYCLE, 40\nSTOP\n"),
      0);
}

}  // namespace
}  // namespace blocks::testing
