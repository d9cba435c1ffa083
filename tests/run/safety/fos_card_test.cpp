// FOS finds the factor of safety and leaves the model as it is.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <numbers>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

/// A square on a floor under gravity that is inclined by 20 degrees. Friction 30
/// degrees holds it with the factor tan 30 / tan 20.
const double known = tangent(30) / tangent(20);
const std::string block_on_plane = [] {
  const double angle = 20.0 * std::numbers::pi / 180.0;
  return preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
         "GRAVITY, " + std::to_string(9.81 * std::sin(angle)) + ", " +
         std::to_string(-9.81 * std::cos(angle)) +
         "\nFRICTN, .57735026919\nLOCDAMP, .8\nSOLVE\n";
}();

Json found(const TemporaryFolder& folder, const std::string& name) {
  return summary(folder, name)["factor_of_safety"];
}

TEST(FosCard, BracketsTheKnownFactor) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a", block_on_plane + "FOS, .005, 1.E-7\nSTOP\n");
  const Json fos = found(folder, "a");
  EXPECT_LT(fos["lower"], known);
  EXPECT_GT(fos["upper"], known);
  EXPECT_LE(fos["upper"].get<double>() - fos["lower"].get<double>(), 0.005);
  EXPECT_EQ(fos["complete"], true);
  for (const Json& trial : fos["trials"])
    EXPECT_EQ(trial["outcome"], trial["factor"] < known ? "stable" : "failing");
  EXPECT_THAT(run.err, HasSubstr("factor of safety between"));
  EXPECT_THAT(slurp(folder / "a.out"), HasSubstr("factor of safety between"));
}

TEST(FosCard, LeavesTheModelAsItIs) {
  const TemporaryFolder folder;
  run_text(folder, "a", block_on_plane + "SETVEL, 2, , .1, 0.\nMOTION, .1\nSTOP\n");
  run_text(folder, "b",
           block_on_plane + "FOS, .1\nSETVEL, 2, , .1, 0.\nMOTION, .1\nSTOP\n");
  EXPECT_EQ(summary(folder, "b")["state_hash"], summary(folder, "a")["state_hash"]);
  EXPECT_EQ(summary(folder, "b")["steps"], summary(folder, "a")["steps"]);
}

TEST(FosCard, HasTheSameBitsForAnyNumberOfTrialsAtOnce) {
  const TemporaryFolder folder;
  const std::string deck = block_on_plane + "FOS\nSTOP\n";
  run_text(folder, "a", deck, "-j 1");
  for (const char* more : {"-j 2", "-j 4 --trials 2", "-j 1 --trials 4"}) {
    run_text(folder, "b", deck, more);
    EXPECT_EQ(found(folder, "b"), found(folder, "a")) << more;
    for (const std::string state : {".stable", ".failing"})
      EXPECT_EQ(summary(folder, "b" + state)["state_hash"],
                summary(folder, "a" + state)["state_hash"])
          << more;
  }
}

TEST(FosCard, GoesOnAfterAnyTrial) {
  const TemporaryFolder folder;
  const std::string deck = block_on_plane + "FOS, .1\nSAVE, end\nCYCLE, 20\nSTOP\n";
  run_text(folder, "a", deck);
  folder.write("b.deck", deck);
  Outcome run = blocks("run b.deck --stop-after 900", folder.path());
  ASSERT_EQ(found(folder, "b")["complete"], false);
  int parts = 1;
  for (; run.code == 75 && parts < 20; ++parts)
    run = blocks("run b.deck --restart b.ckpt.h5 --stop-after 50", folder.path());
  EXPECT_GT(parts, 5);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(found(folder, "b"), found(folder, "a"));
  EXPECT_EQ(summary(folder, "b")["state_hash"], summary(folder, "a")["state_hash"]);
  EXPECT_EQ(summary(folder, "b.failing")["state_hash"],
            summary(folder, "a.failing")["state_hash"]);
  EXPECT_FALSE(folder.holds("b.failing.vtkhdf.bak"));
}

TEST(FosCard, LosesAtMostOneTrialWhenKilled) {
  const TemporaryFolder folder;
  const std::string deck = block_on_plane + "FOS, .0001, 1.E-9, 100000000\nSTOP\n";
  folder.write("a.deck", deck);
  ASSERT_EQ(killed("run a.deck -j 1 -q", "a.failing.summary.json", 0.05, SIGKILL,
                   folder.path()),
            -1);
  const Outcome run = blocks("run a.deck --restart a.ckpt.h5", folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  // The trial at 1 was recorded before that at 2 began, which may be lost.
  EXPECT_THAT(run.err, Not(HasSubstr("strength / 1:")));
  run_text(folder, "b", deck);
  EXPECT_EQ(found(folder, "a"), found(folder, "b"));
}

TEST(FosCard, KeepsTheStatesOfBothEnds) {
  const TemporaryFolder folder;
  run_text(folder, "a", block_on_plane + "FOS, .1\nSTOP\n");
  // The failing block slides on when another deck continues from its state.
  for (const std::string state : {"a.stable", "a.failing"}) {
    run_text(folder, "next", "RESTART, " + state + ".ckpt.h5\nMOTION, .5\nSTOP\n");
    const double speed = summary(folder, "next")["fastest_block"]["speed"];
    if (state == "a.stable")
      EXPECT_LT(speed, 1e-4);
    else
      EXPECT_GT(speed, 1e-2);
  }
  // Files of an earlier run are not taken for those of this one.
  run_text(folder, "a", block_on_plane + "FOS, .1, , , 1.2, 1.3\nSTOP\n");
  EXPECT_FALSE(folder.holds("a.failing.vtkhdf"));
  EXPECT_TRUE(folder.holds("a.failing.vtkhdf.bak"));
  // A run with several failing trials keeps its last state, and the .bak as it was.
  const std::string kept = slurp(folder / "a.failing.vtkhdf.bak");
  run_text(folder, "a", block_on_plane + "FOS, .01, , , 1.2, 2\nSTOP\n");
  EXPECT_TRUE(folder.holds("a.failing.vtkhdf"));
  EXPECT_EQ(slurp(folder / "a.failing.vtkhdf.bak"), kept);
}

TEST(FosCard, IsNotAddedToADeckThatHasIt) {
  const TemporaryFolder folder;
  folder.write("a.deck", block_on_plane + "FOS, .1\nSTOP\n");
  const Outcome run = blocks("fos a.deck --width .2", folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("the deck has this card in line "));
  EXPECT_FALSE(folder.holds("a.out"));
}

TEST(FosCard, TellsWhichBoundDoesNotHold) {
  const TemporaryFolder folder;
  const Outcome low =
      run_text(folder, "a", block_on_plane + "FOS, , , , 1.7, 2\nSTOP\n");
  EXPECT_THAT(low.err, HasSubstr("FOS in line "));
  EXPECT_THAT(low.err, HasSubstr("with strength / 1.7, the lower bound, the model is "
                                 "failing: give a smaller lower bound, or none"));
  EXPECT_TRUE(found(folder, "a")["lower"].is_null());
  EXPECT_EQ(found(folder, "a")["upper"], 1.7);
  const Outcome high =
      run_text(folder, "a", block_on_plane + "FOS, , , , 1, 1.5\nSTOP\n");
  EXPECT_THAT(high.err, HasSubstr("with strength / 1.5, the upper bound, the model is "
                                  "stable: give a larger upper bound, or none"));
  // A block on a level floor needs no strength.
  const Outcome none =
      run_text(folder, "b",
               preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
                   "GRAVITY, 0, -9.81\nFRICTN, .5\nLOCDAMP, .8\nSOLVE\nFOS\nSTOP\n");
  EXPECT_THAT(none.err, HasSubstr("the model is stable with all factors tried"));
}

// A block that falls freely is never at rest, whatever its strength.
TEST(FosCard, NeverTakesAFallForRest) {
  const TemporaryFolder folder;
  const Outcome run = run_text(
      folder, "a",
      preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
          rectangle(-6, 0, -5.5, 1) +
          "GRAVITY, 0, -9.81\nFRICTN, .5\nLOCDAMP, .8\nSOLVE, , 100\nFOS\nSTOP\n");
  EXPECT_TRUE(found(folder, "a")["lower"].is_null());
  EXPECT_THAT(run.err, HasSubstr("joints cannot hold it"));
}

TEST(FosCard, WarnsIfBlocksMoveBefore) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a", block_on_plane + "SETVEL, 2, , .1, 0.\nFOS, .2\nSTOP\n");
  EXPECT_THAT(run.err, HasSubstr("blocks move, and trials should start from rest"));
  EXPECT_THAT(run_text(folder, "b", block_on_plane + "FOS, .2\nSTOP\n").err,
              Not(HasSubstr("should start from rest")));
}

// A row of 60 cubes on a floor is pushed at one end by the force that it resists at F =
// 1.7. Below that its cubes close up slowly, the first one by a twentieth of its size.
// That swing is no failure.
TEST(FosCard, DoesNotTakeASlowSwingForFailure) {
  const TemporaryFolder folder;
  constexpr int cubes = 60;
  constexpr double factor = 1.7, weight = 9810.0;
  std::string deck = preliminary("FUNCTION, 2\n0, 1\n1, 1\nRIGID\n");
  deck.replace(deck.find("-10, 10"), 7, "-9, 99");
  deck.replace(deck.find("FRACTION, 0.02"), 14, "FRACTION");
  deck += rectangle(-1, -1, cubes + 2, 0, true);
  for (int i = 0; i < cubes; ++i)
    deck += rectangle(i, 0, i + 1, 1);
  run_text(folder, "a",
           deck + fmt::format("GRAVITY, 0, -9.81\nFRICTN, .5\nFORCE, 2, {}\n"
                              "LOCDAMP, .8\nSOLVE\nFOS, .05\nSTOP\n",
                              cubes * weight * 0.5 / factor));
  EXPECT_LT(found(folder, "a")["lower"], factor);
  EXPECT_GT(found(folder, "a")["upper"], factor);
  EXPECT_LE(found(folder, "a")["upper"].get<double>() -
                found(folder, "a")["lower"].get<double>(),
            0.05);
}

// What has failed on the way to rest is not there any more.
TEST(FosCard, WarnsIfBlocksHaveLeftBefore) {
  const TemporaryFolder folder;
  const Outcome run = run_text(
      folder, "a",
      preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
          rectangle(-6, -9.8, -5.5, -9) +
          "GRAVITY, 0, -9.81\nFRICTN, .5\nMOTION, .5\nLOCDAMP, .8\nSOLVE\nFOS, .5, , "
          "2000\nSTOP\n");
  EXPECT_THAT(run.err, HasSubstr("1 block has left the domain before it, and only the "
                                 "rest is judged"));
}

TEST(FosCard, NeedsAStateOfEquilibrium) {
  const TemporaryFolder folder;
  folder.write("a.deck", preliminary() + rectangle(0, 0, 1, 1) +
                             "LOCDAMP\nFOS, 0\nFOS, , , , 2, 1\nFOS\nSTOP\n");
  const Outcome run = blocks("check a.deck", folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("FOS: width must be"));
  EXPECT_THAT(run.err, HasSubstr("FOS: lower must be less than upper"));
  EXPECT_THAT(run.err, HasSubstr("FOS: no SOLVE or INSITU before it has balanced"));
}

TEST(FosCommand, FindsTheFactorOfADeckThatEndsInSolve) {
  const TemporaryFolder folder;
  run_text(folder, "a", block_on_plane + "FOS, .05\nSTOP\n");
  folder.write("b.deck", block_on_plane + "STOP\n");
  const Outcome stopped =
      blocks("fos b.deck --width .05 --stop-after 300", folder.path());
  ASSERT_EQ(stopped.code, 75) << stopped.err;
  EXPECT_THAT(stopped.err,
              HasSubstr("blocks fos b.deck --restart b.ckpt.h5 --width 0.05"));
  const Outcome run =
      blocks("fos b.deck --width .05 --restart b.ckpt.h5", folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  Json one = found(folder, "a"), other = found(folder, "b");
  one.erase("line"), other.erase("line");
  EXPECT_EQ(one, other);
  folder.write("c.deck", preliminary() + rectangle(0, 0, 1, 1) + "LOCDAMP\nSTOP\n");
  const Outcome without = blocks("fos c.deck", folder.path());
  EXPECT_EQ(without.code, 3);
  EXPECT_THAT(without.err, HasSubstr("no SOLVE or INSITU before it"));
}

}  // namespace
}  // namespace blocks::testing
