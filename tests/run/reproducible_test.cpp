// The same deck and seed give the same bits, today and on every machine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

std::string shipped(const std::string& name) {
  return fmt::format("'{}/decks/{}/{}.deck' ", BLOCKS_SOURCE_DIR, name, name);
}

// Golden: a change means that some number of the loop changed. Record the new value
// only when that was meant.
TEST(StackDeck, EndsInTheRecordedState) {
  const TemporaryFolder folder;
  ASSERT_EQ(blocks("run " + shipped("stack"), folder.path()).code, 0);
  EXPECT_EQ(summary(folder, "stack")["steps"], 15812);
  EXPECT_EQ(summary(folder, "stack")["state_hash"], "f9c65da26a4a6f69");
}

class SameSeed : public ::testing::Test {
 protected:
  static void run(const TemporaryFolder& folder, const std::string& more) {
    const Outcome outcome = blocks(
        "run " + shipped("crater") + "--set MOTION.dt=0.01 " + more, folder.path());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
};

// Nothing of the place, the time of day or the memory's contents leaks into a run.
TEST_F(SameSeed, GivesTheSameListingAndState) {
  const TemporaryFolder one, two;
  run(one, "");
  run(two, "");
  EXPECT_EQ(slurp(one / "crater.out"), slurp(two / "crater.out"));
  EXPECT_EQ(summary(one, "crater")["state_hash"], summary(two, "crater")["state_hash"]);
}

// Random layers follow the seed, and nothing else: another one, another rock.
TEST_F(SameSeed, AndAnotherSeedDiffers) {
  const TemporaryFolder one, two;
  run(one, "");
  run(two, "--seed 99");
  EXPECT_NE(summary(one, "crater")["state_hash"], summary(two, "crater")["state_hash"]);
  EXPECT_EQ(summary(two, "crater")["seed"], 99);
}

// --seed wins over the SEED card, and means the same as the card.
TEST(SeedOption, WinsOverTheCard) {
  const std::string rest = "LAYER, -9, 1, -8,0, -8,1, 8,1, 8,0, RANDOM\nCYCLE, 1\n";
  const TemporaryFolder folder;
  run_text(folder, "card7", preliminary("SEED, 7\nRIGID\n") + rest);
  run_text(folder, "card8", preliminary("SEED, 8\nRIGID\n") + rest);
  run_text(folder, "option7", preliminary("SEED, 8\nRIGID\n") + rest, "--seed 7");
  EXPECT_NE(summary(folder, "card7")["state_hash"],
            summary(folder, "card8")["state_hash"]);
  EXPECT_EQ(summary(folder, "option7")["state_hash"],
            summary(folder, "card7")["state_hash"]);
}

}  // namespace
}  // namespace blocks::testing
