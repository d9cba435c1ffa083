// The runs of a Sobol design, and how its ranges are read.
#include "sweep/sobol_design.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace blocks::sweep {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string design_fault(const std::string& text) {
  try {
    parse_sobol(text);
  } catch (const AxisFault& fault) {
    EXPECT_FALSE(fault.hint.empty()) << fault.what();
    return fault.what();
  }
  return "no fault";
}

TEST(SobolDesign, RangesAreRead) {
  EXPECT_THAT(parse_sobol("FRICTN.fric=.3..0.6, MATERIAL[2].rho = +2e3..2.6e3"),
              ElementsAre(SobolRange{"FRICTN.fric", 0.3, 0.6},
                          SobolRange{"MATERIAL[2].rho", 2000.0, 2600.0}));
  EXPECT_THAT(parse_sobol("A.b=.3...6"), ElementsAre(SobolRange{"A.b", 0.3, 0.6}));
  EXPECT_THAT(parse_sobol("A.b=-2..-1"), ElementsAre(SobolRange{"A.b", -2.0, -1.0}));
}

TEST(SobolDesign, FaultyRangesAreRefused) {
  for (const char* text : {"", "fric=1..2", "A.b", "A.b=1..2,", "=1..2"})
    EXPECT_THAT(design_fault(text), HasSubstr("expected CARD.field=low..high")) << text;
  for (const char* text : {"A.b=1", "A.b=1,2", "A.b=1..x", "A.b=..2", "A.b=1..inf"})
    EXPECT_THAT(design_fault(text), HasSubstr("expected two numbers")) << text;
  EXPECT_THAT(design_fault("A.b=2..1"), HasSubstr("the low end 2 is not below the high "));
  EXPECT_THAT(design_fault("A.b=2..2"), HasSubstr("the low end 2 is not below the high "));
  EXPECT_THAT(design_fault("A.b=1...5"), HasSubstr("two ways")) << "1 to .5 or 1. to 5";
  EXPECT_THAT(design_fault("A.b=1..2,A.b=3..4"), HasSubstr("A.b is given twice"));
  std::string nine = "A.a=0..1";
  for (char field = 'b'; field <= 'i'; ++field)
    nine += std::string(",A.") + field + "=0..1";
  EXPECT_THAT(design_fault(nine), HasSubstr("has 9 parameters, but at most 8"));
  EXPECT_EQ(design_fault(nine.substr(0, nine.rfind(','))), "no fault");
}

// 2^m points of a Sobol sequence have one point in each of 2^m intervals of each
// coordinate. A digital shift keeps that; it would be lost without the first point.
TEST(SobolDesign, PointsAreEvenlySpreadInEachCoordinate) {
  constexpr std::size_t count = 256, dimension = 16;
  for (const std::uint64_t seed : {0, 1, 77}) {
    const auto points = sobol_points(count, dimension, seed);
    for (std::size_t d = 0; d < dimension; ++d) {
      std::set<int> intervals;
      for (const auto& point : points) {
        EXPECT_GT(point[d], 0.0);
        EXPECT_LT(point[d], 1.0);
        intervals.insert(static_cast<int>(std::floor(point[d] * count)));
      }
      EXPECT_EQ(intervals.size(), count) << seed << ' ' << d;
    }
  }
  EXPECT_NE(sobol_points(4, 2, 1), sobol_points(4, 2, 2));
}

// Also in each pair of coordinates: 16 by 16 cells of 256 points of the first two.
TEST(SobolDesign, PointsFillTheCellsOfAPair) {
  std::set<int> cells;
  for (const auto& point : sobol_points(256, 2, 5))
    cells.insert(static_cast<int>(point[0] * 16) * 16 +
                 static_cast<int>(point[1] * 16));
  EXPECT_EQ(cells.size(), 256U);
}

TEST(SobolDesign, ARowHasBothPointsAndTheirMixtures) {
  const SobolDesign design{parse_sobol("A.x=0..1,A.y=10..20,A.z=-1..1"), 8, 3};
  const Variation common{7, {"B.c=5"}};
  const auto runs = sobol_runs(design, common);
  ASSERT_EQ(runs.size(), 8U * 5U);
  for (std::size_t row = 0; row < 8; ++row) {
    const auto at = [&](std::size_t run, std::size_t set) {
      return runs[5 * row + run].sets.at(set);
    };
    for (std::size_t i = 1; i <= 3; ++i)
      for (std::size_t set = 0; set <= 3; ++set)
        EXPECT_EQ(at(1 + i, set), at(set == i ? 1 : 0, set));
    EXPECT_EQ(at(0, 0), "B.c=5");
    EXPECT_NE(at(0, 1), at(1, 1));
    const double y = std::stod(value_of(at(0, 2)));
    EXPECT_GT(y, 10.0);
    EXPECT_LT(y, 20.0);
    EXPECT_EQ(runs[5 * row].seed, 7U);
  }
  // More rows begin with the same ones.
  const auto more = sobol_runs({design.ranges, 16, 3}, common);
  EXPECT_TRUE(std::equal(runs.begin(), runs.end(), more.begin()));
}

TEST(SobolDesign, CornersAreAllOfThem) {
  const SobolDesign design{parse_sobol("A.x=0..1,A.y=2..3"), 2, 0};
  std::set<std::string> corners;
  for (const Variation& run : sobol_corners(design, {}))
    corners.insert(words_of(run));
  EXPECT_THAT(corners, ElementsAre("A.x=0, A.y=2", "A.x=0, A.y=3", "A.x=1, A.y=2",
                                   "A.x=1, A.y=3"));
}

}  // namespace
}  // namespace blocks::sweep
