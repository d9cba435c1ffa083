// `blocks run --audit` as a user sees it: what it counts, and how a run ends whose
// contacts are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/checkpoint.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string pair_of_squares = preliminary() + rectangle(-2, -1, 2, 0, true) +
                                    rectangle(-0.5, 0, 0.5, 1) +
                                    "GRAVITY, 0, -10\nDAMPING, 0.3\n";

// An audit judges and changes nothing: no bit of the run.
TEST(RunAudit, ChangesNoBit) {
  const TemporaryFolder folder;
  run_text(folder, "plain", pair_of_squares + "MOTION, 0.4\nSTOP\n");
  run_text(folder, "audited", pair_of_squares + "MOTION, 0.4\nSTOP\n", "--audit=50");
  const auto plain = summary(folder, "plain"), audited = summary(folder, "audited");
  EXPECT_EQ(plain["state_hash"], audited["state_hash"]);
  EXPECT_TRUE(plain["audit"].is_null());
  const auto& audit = audited["audit"];
  EXPECT_EQ(audit["every"], 50);
  EXPECT_EQ(audit["moments"], (audited["steps"].get<long>() + 49) / 50);
  // two corners on the floor; in the first step nothing overlaps yet
  EXPECT_EQ(audit["acting"], 2 * (audit["moments"].get<long>() - 1));
  EXPECT_EQ(audit["wrong_decisions"], 0);
  EXPECT_EQ(audit["missed_pairs"], 0);
  // a run that is stopped and goes on leaves the same listing
  folder.write("resumed.deck", pair_of_squares + "MOTION, 0.4\nSTOP\n");
  ASSERT_EQ(blocks("run resumed.deck --audit=50 --stop-after 77", folder.path()).code,
            75);
  run_text(folder, "resumed", pair_of_squares + "MOTION, 0.4\nSTOP\n",
           "--audit=50 --restart resumed.ckpt.h5");
  std::string listing = slurp(folder / "resumed.out");
  for (std::size_t at = 0; (at = listing.find("resumed", at)) != std::string::npos;)
    listing.replace(at, 7, "audited");
  EXPECT_EQ(listing, slurp(folder / "audited.out"));
}

// Blocks in flight and rubble, as a shipped deck makes them.
TEST(RunAudit, CraterIsCleanWhileBlocksFly) {
  const TemporaryFolder folder;
  const Outcome run = blocks("run '" BLOCKS_SOURCE_DIR "/decks/crater/crater.deck' "
                             "--set MOTION.dt=0.06 --audit",
                             folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto audit = summary(folder, "crater")["audit"];
  EXPECT_GT(audit["acting"].get<long>(), 1000);
  EXPECT_EQ(audit["faults"], nlohmann::json::array());
  EXPECT_EQ(audit["excess_pairs"], 0);
}

/// A state in which the list has lost the records of the square's first corner.
void lose_records(const TemporaryFolder& folder) {
  const std::string path = (folder / "squares.ckpt.h5").string();
  output::CheckpointInfo info;
  Model model = output::read_checkpoint(path, info);
  ASSERT_TRUE(model.search.current);
  Contacts& all = model.contacts;
  Contacts rest;
  int kept = 0;
  rest.resize(all.size());
  for (int i = 0; i < all.size(); ++i) {
    if (all.corner[i] == 4)
      continue;
    rest.corner[kept] = all.corner[i], rest.edge[kept] = all.edge[i];
    rest.active[kept] = all.active[i];
    if (all.active[i]) {
      rest.acting.push_back(all.at(i));
      rest.acting.back().record = kept;
    }
    ++kept;
  }
  ASSERT_LT(kept, all.size());
  for (auto* column : {&rest.corner, &rest.edge})
    column->resize(kept);
  rest.active.resize(kept);
  all = rest;
  output::write_checkpoint(path, model, info);
}

// A list that misses a contact ends the run, with the story of that contact.
TEST(RunAudit, AMissedContactIsUnsound) {
  const TemporaryFolder folder;
  run_text(folder, "squares", pair_of_squares + "MOTION, 0.4\nSTOP\n");
  lose_records(folder);
  folder.write("on.deck", "RESTART, squares.ckpt.h5\nCYCLE, 10\nSTOP\n");

  const Outcome blind = blocks("run on.deck -o blind", folder.path());
  EXPECT_EQ(blind.code, 0) << "unseen without audit: " << blind.err;

  const Outcome run = blocks("run on.deck --audit=1", folder.path());
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("audit: the contact list misses corner 1 of block 2 "
                                 "against edge 2 of block 1, which acts"));
  EXPECT_THAT(run.err, HasSubstr("audit: wrong decision: corner 1 of block 2 against "
                                 "block 1: no edge acts, exactly it is edge 2"));
  EXPECT_THAT(run.err, HasSubstr("nearest of those admitted, acts"));  // the story
  const auto json = summary(folder, "on");
  EXPECT_EQ(json["status"], "unsound");
  EXPECT_EQ(json["audit"]["wrong_decisions"], 1);
  EXPECT_EQ(json["steps"], summary(folder, "squares")["steps"].get<long>() + 1);
  EXPECT_THAT(slurp(folder / "on.out"), HasSubstr("the contact list misses"));
}

TEST(RunAudit, EveryIsAWholeNumberOfSteps) {
  const TemporaryFolder folder;
  folder.write("a.deck", pair_of_squares + "CYCLE, 5\nSTOP\n");
  for (const char* value : {"0", "-1", "1.5", "x", "99999999999999999999"}) {
    const Outcome run =
        blocks(std::string("run a.deck --audit=") + value, folder.path());
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("expected a whole number of steps from 1")) << value;
  }
  EXPECT_EQ(blocks("run --audit a.deck -o b", folder.path()).code, 0);
}

TEST(AuditOption, SaysHowTheNumberIsGiven) {
  const TemporaryFolder folder;
  folder.write("t.deck", pair_of_squares + "STOP\n");
  for (const char* words : {"run --audit 5 t.deck", "run t.deck --audit 5"}) {
    const Outcome done = blocks(words, folder.path());
    EXPECT_EQ(done.code, 2);
    EXPECT_THAT(done.err, HasSubstr("every 5 steps is --audit=5")) << words;
  }
}

}  // namespace
}  // namespace blocks::testing
