// The same deck and seed give the same bits on every machine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

std::string shipped(const std::string& name) {
  return fmt::format("'{}/decks/{}/{}.deck' ", BLOCKS_SOURCE_DIR, name, name);
}

// If the hash changes, some number of the time loop has changed. Record the new value
// only if the change is intended.
TEST(StackDeck, EndsInTheRecordedState) {
  const TemporaryFolder folder;
  ASSERT_EQ(blocks("run " + shipped("stack"), folder.path()).code, 0);
  EXPECT_EQ(summary(folder, "stack")["steps"], 15812);
  EXPECT_EQ(summary(folder, "stack")["state_hash"], "7e47a10e7334d8ca");
}

// Contact forces are computed with the best instruction set unless BLOCKS_SIMD is set.
TEST(StackDeck, EndsInTheRecordedStateWithBaselineInstructions) {
  const TemporaryFolder folder;
  ::setenv("BLOCKS_SIMD", "baseline", 1);
  const int code = blocks("run " + shipped("stack"), folder.path()).code;
  ::unsetenv("BLOCKS_SIMD");
  ASSERT_EQ(code, 0);
  EXPECT_EQ(summary(folder, "stack")["state_hash"], "7e47a10e7334d8ca");
}

// The hashes record the random blocks of decks of users. Random streams depend on the
// layer itself. Corners inside slanted sides are rounded out of them.
class RandomDeck : public ::testing::Test {
 protected:
  /// Returns the blocks of a deck with these cards. Each line has one block, with all
  /// digits of its coordinates.
  static std::string blocks_of(const std::string& cards) {
    const TemporaryFolder folder;
    folder.write("a.deck",
                 preliminary("SEED, 7\nRIGID\n") + "ORIENT, -20, 20\n" + cards);
    const Outcome outcome = blocks("export a.deck -o a.wkt", folder.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return slurp(folder / "a.wkt");
  }
  /// Returns the FNV-1a hash of the text.
  static std::uint64_t hash_of(const std::string& text) {
    std::uint64_t value = 0xcbf29ce484222325ULL;
    for (const char c : text)
      value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return value;
  }
  static constexpr const char *dip = "LAYER, -20, 1, 0,0, 0,.1, 3,.4, 3,.3, RANDOM\n",
                              *below =
                                  "LAYER, -9, 1, .7,-.13, .7,.07, 2,.2, 2,0, RANDOM\n",
                              *flat =
                                  "LAYER, -12, 1, -8,-3, -8,-2, 1,-2, 1,-3, RANDOM\n";
};

TEST_F(RandomDeck, HasTheRecordedBlocks) {
  EXPECT_EQ(hash_of(blocks_of(dip)), 7450499982707835104U);
  EXPECT_EQ(hash_of(blocks_of(std::string(dip) + below)), 12673284550278504968U);
}

TEST_F(RandomDeck, HasLayersThatDoNotDependOnEachOther) {
  const std::string alone = blocks_of(dip);
  EXPECT_EQ(blocks_of(std::string(dip) + flat), alone + blocks_of(flat));
  EXPECT_EQ(blocks_of(std::string(flat) + dip), blocks_of(flat) + alone);
}

class Seed : public ::testing::Test {
 protected:
  static void run(const TemporaryFolder& folder, const std::string& more) {
    const Outcome outcome = blocks(
        "run " + shipped("crater") + "--set MOTION.dt=0.01 " + more, folder.path());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
};

TEST_F(Seed, GivesTheSameListingAndStateInAnotherFolder) {
  const TemporaryFolder one, two;
  run(one, "");
  run(two, "");
  EXPECT_EQ(slurp(one / "crater.out"), slurp(two / "crater.out"));
  EXPECT_EQ(summary(one, "crater")["state_hash"], summary(two, "crater")["state_hash"]);
}

TEST_F(Seed, GivesAnotherStateIfItDiffers) {
  const TemporaryFolder one, two;
  run(one, "");
  run(two, "--seed 99");
  EXPECT_NE(summary(one, "crater")["state_hash"], summary(two, "crater")["state_hash"]);
  EXPECT_EQ(summary(two, "crater")["seed"], 99);
}

TEST(SeedOption, ReplacesTheSeedCard) {
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
