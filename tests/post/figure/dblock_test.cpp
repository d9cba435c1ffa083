// `blocks plot --dblock` draws the plots of the cards of Appendix E.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

class Dblock : public ::testing::Test {
 protected:
  void SetUp() override {
    run_text(folder_, "fall",
             preliminary() + rectangle(0, 0, 1, 1) +
                 "GRAVITY, 0, -10\nPLOTS, 0.01\nCYCLE, 100\n");
  }
  Outcome plot(const std::string& cards) const {
    folder_.write("cards.txt", cards);
    return blocks("plot --dblock cards.txt fall.vtkhdf", folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(Dblock, PlotsAllTimesOfTheCards) {
  const Outcome plots = plot("TIMES, 0.\nTIMES, 0.01, 0.02\nENDDATA\nNONSENSE\n");
  EXPECT_EQ(plots.code, 0) << plots.err;
  for (const char* name : {"fall_01.png", "fall_02.png", "fall_03.png"})
    EXPECT_TRUE(folder_.holds(name)) << name;
  EXPECT_FALSE(folder_.holds("fall_04.png"));
}

TEST_F(Dblock, PlotsTheLastFrameWithoutTimes) {
  EXPECT_EQ(plot("BLOCKS\nFLIP\nRED, 1\nFRAMESIZE, 2\n").code, 0);
  EXPECT_TRUE(folder_.holds("fall.png"));
}

// TMIN and TMAX limit the times of the frames.
TEST_F(Dblock, AcceptsTimeLimitsBeyondTheResults) {
  const Outcome plots = plot("TMIN, -5\nTMAX, 100\nNTIMES, 2\n");
  EXPECT_EQ(plots.code, 0) << plots.err;
  EXPECT_THAT(plots.out, HasSubstr("fall_01.png time 0\nfall_02.png time 0.04"));
  EXPECT_THAT(plot("TMIN, 50").err, HasSubstr("no picture between TMIN and TMAX"));
}

// A card or option without effect would be misleading.
TEST_F(Dblock, RefusesAnOptionThatContradictsACard) {
  folder_.write("cards.txt", "ZOOM, 0, 1, 0, 1\nFLIP\nRED, 1\n");
  const auto said = [&](const std::string& options) {
    const Outcome outcome =
        blocks("plot " + options + " fall.vtkhdf --dblock cards.txt", folder_.path());
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(said("--zoom 0,1,0,1"), HasSubstr("--zoom and the card ZOOM exclude"));
  EXPECT_THAT(said("--mirror 1"), HasSubstr("--mirror and the card FLIP exclude"));
  EXPECT_THAT(said("--colour speed"), HasSubstr("--colour speed and the card RED"));
  EXPECT_THAT(said("--materials 1=BLUE"), HasSubstr("--materials 1=... and the card"));
}

TEST_F(Dblock, PrintsTheCornersOfBlocks) {
  EXPECT_THAT(plot("print\nblocks\n").out,
              HasSubstr("       1       2                 0                 1\n"));
}

TEST_F(Dblock, ReportsFaultsWithTheirPlaces) {
  const Outcome faults = plot("ZOOM, 1, 0, 0, 1\nTMAX, late\nGREAN, 1\nFRAMESIZE, 4\n");
  EXPECT_EQ(faults.code, 3);
  EXPECT_THAT(faults.err,
              HasSubstr("cards.txt:1:1: error: ZOOM: expected xmin < xmax"));
  EXPECT_THAT(faults.err, HasSubstr("cards.txt:2:7: error: TMAX: expected a number"));
  EXPECT_THAT(faults.err, HasSubstr("error: DBLOCK has no card 'GREAN'\n"));
  EXPECT_THAT(faults.err, HasSubstr("did you mean GREEN?"));
  EXPECT_THAT(faults.err, HasSubstr("cards.txt:4:12: error: FRAMESIZE: expected 1, 2"));
  EXPECT_THAT(plot("BLUE, 1\nRED, 77").err,
              HasSubstr("cards.txt:2:6: error: RED: there is no material 77; the "
                        "results have 1"));
  EXPECT_THAT(plot("RED").err, HasSubstr("RED: expected 1 number, found 0"));
  EXPECT_THAT(plot("ZOOM, 50, 60, 50, 60").err, HasSubstr("no block in the zoom"));
  EXPECT_THAT(plot("BLOCKS\n\x01").err,
              HasSubstr("cards.txt:2:1: error: not a text file"));
  EXPECT_THAT(plot("TIMES, 77").err, HasSubstr("fall.vtkhdf has times 0 to "));
}

}  // namespace
}  // namespace blocks::testing
