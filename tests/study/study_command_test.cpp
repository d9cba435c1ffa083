// `blocks study contacts` as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

TEST(StudyCommand, TableCsvAndJson) {
  const TemporaryFolder folder;
  folder.write("t.csv", "older");
  const Outcome done = blocks("study contacts tee figure4b --frames 3 --steps 20 "
                              "--variants default,report --csv t.csv --json t.json",
                              folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("3 frames of 20 steps"));
  EXPECT_THAT(done.out, HasSubstr("0/3 0-56"));
  const std::string csv = slurp(folder / "t.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_THAT(csv, HasSubstr("\nfigure4b,report,3,20,"));
  EXPECT_EQ(slurp(folder / "t.csv.bak"), "older");
  const auto json = nlohmann::json::parse(slurp(folder / "t.json"));
  EXPECT_EQ(json["studies"][0]["variants"][0]["hang_ups"]["value"], 0.0);
}

TEST(StudyCommand, TakesADeck) {
  const TemporaryFolder folder;
  const Outcome done =
      blocks("study contacts " BLOCKS_SOURCE_DIR "/decks/stack/stack.deck --frames 2 "
             "--steps 100 --variants default",
             folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("0/2 0-66"));
  EXPECT_EQ(blocks("study contacts none.deck", folder.path()).code, 5);
}

TEST(StudyCommand, SaysWhatThereIs) {
  const TemporaryFolder folder;
  const Outcome scene = blocks("study contacts figure4", folder.path());
  EXPECT_EQ(scene.code, 2);
  EXPECT_THAT(scene.err, HasSubstr("no scene figure4; did you mean figure4b?"));
  EXPECT_THAT(scene.err, HasSubstr("\n  shaft "));
  const Outcome variant =
      blocks("study contacts tee --variants default,exakt", folder.path());
  EXPECT_EQ(variant.code, 2);
  EXPECT_THAT(variant.err, HasSubstr("there is no variant exakt"));
  EXPECT_THAT(variant.err, HasSubstr("\n  no-nearest "));
  EXPECT_EQ(blocks("study contacts", folder.path()).code, 2);
  EXPECT_EQ(blocks("study contacts tee --frames 0", folder.path()).code, 2);
}

}  // namespace
}  // namespace blocks::testing
