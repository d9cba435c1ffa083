// The cards LOCDAMP and KINDAMP and the ramp of GRAVITY in a run: the warning of flight
// and the listing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/safe_fraction.hpp"
#include "tools/program.hpp"

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

/// Runs a deck without FRACTION and returns the time steps that the run names.
std::vector<double> steps_without_fraction(const std::string& cards) {
  const TemporaryFolder folder;
  std::string text = falls;
  const std::size_t at = text.find("FRACTION");
  text.erase(at, text.find('\n', at) + 1 - at);
  const Outcome run = run_text(folder, "auto", text + cards);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("FRACTION 0 ")));
  std::vector<double> steps;
  for (std::size_t dt = run.err.find("dt "); dt != std::string::npos;
       dt = run.err.find("dt ", dt + 1))
    steps.push_back(std::stod(run.err.substr(dt + 3)));
  return steps;
}

// A step that is safe without damping makes damped blocks jitter for ever.
TEST(Fraction, IsTheLargestSafeOneForTheDampingInForceIfAbsent) {
  const std::vector<double> steps = steps_without_fraction(
      "CYCLE, 1\nDAMPING, .5\nCYCLE, 1\nLOCDAMP, .7\nCYCLE, 1\nDAMPING, 0\n"
      "LOCDAMP, 0\nCYCLE, 1\n");
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_NEAR(steps[1] / steps[0], safe_fraction(.5) / safe_fraction(0), 1e-4);
  EXPECT_NEAR(steps[2] / steps[0], safe_fraction(.5, .7) / safe_fraction(0), 1e-4);
  EXPECT_EQ(steps[3], steps[0]);
}

TEST(Fraction, OfTheDeckStaysWhenDampingChanges) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "given", falls + "CYCLE, 1\nDAMPING, .3\nCYCLE, 1\n");
  EXPECT_THAT(run.err, Not(HasSubstr("from now on")));
}

}  // namespace
}  // namespace blocks::testing
