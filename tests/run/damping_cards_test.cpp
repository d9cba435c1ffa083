// The cards LOCDAMP and KINDAMP and the ramp of GRAVITY in a run: the warning of flight
// and the listing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Block 2 rests on the floor, block 1, and block 3 falls beside it.
const std::string falls = preliminary() + rectangle(-5, -1, 5, 0, true) +
                          rectangle(-3, 0, -2, 1) + rectangle(1, 3, 2, 4) +
                          "GRAVITY, 0, -10\n";
constexpr const char* flies = "flies at time";

TEST(LocalDampingCard, WarnsOnceOfABlockThatFlies) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "fall", falls + "LOCDAMP, .5\nMOTION, 0.8\n");
  EXPECT_THAT(run.err, AllOf(HasSubstr("block 3 flies at time 0.2"),
                             HasSubstr("LOCDAMP 0.5"), HasSubstr("0.5 of gravity")));
  const std::string all = summary(folder, "fall")["warnings"].dump();
  EXPECT_EQ(all.find(flies), all.rfind(flies));
  EXPECT_THAT(all, HasSubstr(flies));
}

TEST(LocalDampingCard, DoesNotWarnOfBlocksThatRestOrSettle) {
  const TemporaryFolder folder;
  // The gap is less than ctol.
  const std::string settles = preliminary() + rectangle(-5, -1, 5, 0, true) +
                              rectangle(-3, 0, -2, 1) + rectangle(1, 0.05, 2, 1) +
                              "GRAVITY, 0, -10\n";
  EXPECT_THAT(run_text(folder, "s", settles + "LOCDAMP\nMOTION, 0.8\n").err,
              Not(HasSubstr(flies)));
  EXPECT_THAT(run_text(folder, "n", falls + "MOTION, 0.5\n").err,
              Not(HasSubstr(flies)));
}

TEST(DampingCards, AreEchoedInTheListingOnlyIfUsed) {
  const TemporaryFolder folder;
  run_text(folder, "plain", falls + "MOTION, 0.01\n");
  const std::string plain = slurp(folder / "plain.out");
  run_text(folder, "damped",
           falls + "GRAVITY, 1, -9, 0.5\nLOCDAMP, .3\nKINDAMP\nMOTION, 0.01\n");
  const std::string damped = slurp(folder / "damped.out");
  for (const char* name : {"TRAMP", "GRAVY0", "ALPHA", "KINDAMP"}) {
    EXPECT_THAT(damped, HasSubstr(name));
    EXPECT_THAT(plain, Not(HasSubstr(name)));
  }
}

// Local damping makes springs stiffer by 1 + alpha on their way out.
TEST(LocalDampingCard, LowersTheLargestSafeFraction) {
  const TemporaryFolder folder;
  folder.write("f.deck", preliminary() + rectangle(0, 0, 1, 1) +
                             "CYCLE, 1\nLOCDAMP, .8\nCYCLE, 1\n");
  const Outcome run = blocks("check f.deck --set FRACTION.tfrac=0.12", folder.path());
  EXPECT_THAT(run.err,
              HasSubstr("LOCDAMP: FRACTION 0.12 with DAMPING 0 and LOCDAMP 0.8"));
}

}  // namespace
}  // namespace blocks::testing
