// A corner at a joint of a floor or wall moves as on a floor or wall of one block.
#include <gtest/gtest.h>

#include "run/program.hpp"

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

}  // namespace
}  // namespace blocks::testing
