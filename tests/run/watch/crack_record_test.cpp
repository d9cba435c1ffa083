// The record of cracks across stops and restarts, and what a run tells about cracks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Returns a deck whose block is pulled apart into four pieces.
std::string torn() {
  return preliminary("FUNCTION, 1\n0., 1.\n") + rectangle(0, 0, 1, 1) +
         "PRESSBC, 1, 1, -1.2E6, -1.2E6\nPRESSBC, 1, 3, -1.2E6, -1.2E6\n"
         "CRACK, 1, 1.E6, 0.1\nHISTORY, 0.0001, cracks\nPLOTS, 0.0001\n"
         "MOTION, 0.004\n";
}

/// Everything that the results record of cracks, as text.
std::string record_of(const TemporaryFolder& folder, const std::string& name) {
  const post::ResultsReader results((folder / (name + ".vtkhdf")).string());
  std::string text;
  for (const post::Crack& crack : results.cracks())
    for (const double value :
         {static_cast<double>(crack.step), crack.time,
          static_cast<double>(crack.parent), static_cast<double>(crack.child),
          crack.stress, crack.from.x(), crack.from.y(), crack.to.x(), crack.to.y(),
          crack.parent_area, crack.child_area, crack.kinetic_before,
          crack.kinetic_after, crack.strain_before, crack.strain_after})
      text += std::to_string(value) + " ";
  for (long i = 0; i < results.frames(); ++i) {
    const post::Frame frame = results.frame(i);
    text += "\n" + std::to_string(frame.time) + " " + std::to_string(frame.cracks);
    for (const int parent : frame.parent)
      text += " " + std::to_string(parent);
  }
  return text;
}

TEST(CrackRecord, HistoriesCountInWholeNumbers) {
  const TemporaryFolder folder;
  std::string deck = torn();
  deck.replace(deck.find("HISTORY, 0.0001"), 15, "HISTORY, 0.00001");
  run_text(folder, "torn", deck);
  const post::ResultsReader results((folder / "torn.vtkhdf").string());
  const auto cracks = results.cracks();
  const auto sections = results.recorded();
  ASSERT_EQ(sections.size(), 1U);
  for (std::size_t k = 0; k < sections[0].time.size(); ++k) {
    const double t = sections[0].time[k];
    const auto until_then =
        std::count_if(cracks.begin(), cracks.end(),
                      [&](const auto& crack) { return crack.time <= t; });
    EXPECT_EQ(sections[0].values(0, static_cast<Eigen::Index>(k)), until_then) << t;
  }
}

// Stopped before the first crack, between cracks, and after the last one. The files are
// those of the run that was not stopped.
TEST(CrackRecord, IsTheSameAcrossARestart) {
  const TemporaryFolder folder;
  run_text(folder, "straight", torn());
  const auto straight = summary(folder, "straight");
  ASSERT_EQ(straight["crack_counts"]["all"], 3);
  const long first = straight["cracks"][0]["step"],
             last = straight["cracks"][2]["step"];
  ASSERT_LT(first, last);
  for (const long stop : {first - 1, first, first + 1, (first + last) / 2, last + 1}) {
    folder.write("parts.deck", torn());
    EXPECT_EQ(
        blocks("run parts.deck --stop-after " + std::to_string(stop), folder.path())
            .code,
        75);
    const Outcome rest =
        blocks("run parts.deck --restart parts.ckpt.h5", folder.path());
    ASSERT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(record_of(folder, "parts"), record_of(folder, "straight")) << stop;
    const auto parts = summary(folder, "parts");
    for (const char* key : {"cracks", "refused_cracks", "crack_counts", "state_hash"})
      EXPECT_EQ(parts[key], straight[key]) << key << " after " << stop;
  }
}

TEST(CrackRecord, IsToldInTheListingAndAtTheEnd) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "torn", torn());
  EXPECT_THAT(run.err, HasSubstr("(the stiffness of a piece of it)"));
  EXPECT_THAT(run.err,
              HasSubstr("3 cracks (3 by stress, 0 by point loads); 2 blocks "
                        "did not split at first: a piece would be too thin for the "
                        "time step"));
  const std::string listing = slurp(folder / "torn.out");
  EXPECT_THAT(listing, HasSubstr("block 1 split into 1 and 2 (stress 1"));
  EXPECT_THAT(listing, HasSubstr(", angle 90 degrees; areas 0.5"));
  EXPECT_THAT(listing, HasSubstr("\n  energy released "));
  EXPECT_THAT(listing, AllOf(HasSubstr("block 1 split into 1 and 3"),
                             HasSubstr("block 2 split into 2 and 4")));
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.size() <= 132U || line.starts_with("warning: ")) << line;
  EXPECT_EQ(summary(folder, "torn")["dt"]["pieces"], true);
  const Outcome check = blocks("check torn.deck", folder.path());
  EXPECT_THAT(check.out, HasSubstr("material 1: blocks split at a tension of 1e+06"));
}

}  // namespace
}  // namespace blocks::testing
