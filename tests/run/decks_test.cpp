// Every shipped deck passes the check and a short run.
#include <gtest/gtest.h>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

class ShippedDeck : public ::testing::TestWithParam<fs::path> {
 protected:
  std::string name() const { return GetParam().stem().string(); }
  std::string quoted() const { return "'" + GetParam().string() + "'"; }
};

TEST_P(ShippedDeck, PassesCheck) {
  const TemporaryFolder folder;
  const Outcome check = blocks("check " + quoted(), folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("no errors"), std::string::npos) << check.out;
  EXPECT_TRUE(fs::is_empty(folder.path())) << "check writes no file";
}

// The results have the states at the start and at the end for any PLOTS card.
TEST_P(ShippedDeck, RunsSoundlyAndWritesItsFiles) {
  const TemporaryFolder folder;
  const std::string deck = slurp(GetParam());
  const bool moves = has_card(deck, "MOTION");
  const Outcome run =
      blocks("run " + quoted() + (moves ? " --set MOTION.dt=0.002 " : " ") +
                 fewer_solves(deck) + "--audit=20",
             folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"})
    EXPECT_TRUE(folder.holds(name() + ending)) << ending;

  const auto json = summary(folder, name());
  const post::ResultsReader results((folder / (name() + ".vtkhdf")).string());
  ASSERT_GE(results.frames(), 2);
  EXPECT_EQ(results.times().front(), 0.0);
  EXPECT_EQ(results.times().back(), json["time"].get<double>());
  EXPECT_EQ(results.frame(0).step, 0);
  EXPECT_EQ(results.frame(results.frames() - 1).step, json["steps"].get<long>());
  EXPECT_EQ(results.frames(), json["frames"].get<long>());
  EXPECT_EQ(results.frame(results.frames() - 1).outlines.size(),
            json["blocks"].get<std::size_t>());
  // MOTION makes ceil(dt / TDEL - 1e-9) steps, so that round-off adds no step.
  if (moves) {
    EXPECT_GE(json["time"].get<double>(), 0.002 * (1 - 1e-9));
  }
  EXPECT_EQ(json["status"], "done");
  EXPECT_GE(json["audit"]["moments"].get<long>(), 1);
  EXPECT_EQ(json["audit"]["faults"], nlohmann::json::array());
  EXPECT_EQ(json["audit"]["excess_pairs"], 0);
}

INSTANTIATE_TEST_SUITE_P(Decks, ShippedDeck, ::testing::ValuesIn(decks_below("decks")),
                         [](const auto& one) { return one.param.stem().string(); });

// Without decks the tests above would pass.
TEST(ShippedDecks, AreFound) { EXPECT_GE(decks_below("decks").size(), 9U); }

}  // namespace
}  // namespace blocks::testing
