// `blocks plot --dblock`: the cards of Appendix E give the plots they gave in 1982.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/program.hpp"

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

TEST_F(Dblock, TimesAreThoseAskedFor) {
  const Outcome plots = plot("TIMES, 0.\nTIMES, 0.01, 0.02\nENDDATA\nNONSENSE\n");
  EXPECT_EQ(plots.code, 0) << plots.err;
  for (const char* name : {"fall_01.png", "fall_02.png", "fall_03.png"})
    EXPECT_TRUE(folder_.holds(name)) << name;
  EXPECT_FALSE(folder_.holds("fall_04.png"));
  EXPECT_EQ(plot("BLOCKS\nFLIP\nRED, 1\nFRAMESIZE, 2\n").code, 0);
  EXPECT_TRUE(folder_.holds("fall.png"));
}

TEST_F(Dblock, PrintGivesTheCorners) {
  EXPECT_THAT(plot("print\nblocks\n").out,
              HasSubstr("       1       2                 0                 1\n"));
}

TEST_F(Dblock, FaultsAreReportedAtTheirPlaces) {
  const Outcome faults = plot("ZOOM, 1, 0, 0, 1\nTMAX, late\nGREAN, 1\nFRAMESIZE, 4\n");
  EXPECT_EQ(faults.code, 3);
  EXPECT_THAT(faults.err,
              HasSubstr("cards.txt:1:1: error: ZOOM: expected xmin < xmax"));
  EXPECT_THAT(faults.err, HasSubstr("cards.txt:2:7: error: TMAX: expected a number"));
  EXPECT_THAT(faults.err, HasSubstr("did you mean GREEN?"));
  EXPECT_THAT(faults.err, HasSubstr("cards.txt:4:12: error: FRAMESIZE: expected 1, 2"));
  EXPECT_THAT(plot("TIMES, 77").err, HasSubstr("fall.vtkhdf has times 0 to "));
}

}  // namespace
}  // namespace blocks::testing
