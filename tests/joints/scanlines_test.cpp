// Spacings along scanlines.
#include <gtest/gtest.h>

#include <cmath>

#include "joints/scanlines.hpp"
#include "validation/traces/maps.hpp"

namespace blocks::joints {
namespace {

using testing::generated;
using testing::joint_set;
using testing::map_of;
using testing::rectangle;
using testing::SetNumbers;

TEST(Scanlines, CrossingsInOrderWithTheirAngles) {
  const Network n = network_of(
      map_of("0 0 0 10 10 10 10 0", {"2 1 2 9", "4 1 8 9", "7 6 7 9", "1 5 1.5 5"}));
  const auto found = crossings_of({{-3, 5}, {20, 5}}, n);
  ASSERT_EQ(found.size(), 2U);  // a trace along the line is not crossed
  EXPECT_DOUBLE_EQ(found[0].place, 5.0);
  EXPECT_DOUBLE_EQ(found[0].cosine, 1.0);
  EXPECT_DOUBLE_EQ(found[1].place, 9.0);
  EXPECT_NEAR(found[1].cosine, 2.0 / std::sqrt(5.0), 1e-12);
  const SpacingStatistics s = spacing_statistics({{{-3, 5}, {20, 5}}}, n);
  EXPECT_DOUBLE_EQ(s.length, 10.0);
  EXPECT_DOUBLE_EQ(s.mean, 4.0);
  EXPECT_DOUBLE_EQ(s.frequency, 0.2);
}

// A bend on the line is above it. So a trace through the line counts once, and one that
// touches it from below counts twice, as for a line that is a little lower.
TEST(Scanlines, BendsOnTheLine) {
  const std::string window = "0 0 0 10 10 10 10 0";
  const Scanline line{{0, 5}, {10, 5}};
  const auto count = [&](const std::string& trace) {
    return crossings_of(line, network_of(map_of(window, {trace}))).size();
  };
  EXPECT_EQ(count("2 1 3 5 2 9"), 1U);
  EXPECT_EQ(count("5 1 5 5 6 1"), 2U);
  EXPECT_EQ(count("5 9 5 5 6 9"), 0U);
}

TEST(Scanlines, SpacingsDoNotBridgeWhatIsOutsideOfTheWindow) {
  const Network n = network_of(map_of("0 0 0 10 3 10 3 4 7 4 7 10 10 10 10 0",
                                      {"1 1 1 9", "2 1 2 9", "8 1 8 9", "9 1 9 9"}));
  const SpacingStatistics s = spacing_statistics({{{0, 8}, {10, 8}}}, n);
  EXPECT_DOUBLE_EQ(s.length, 6.0);
  EXPECT_EQ(s.crossings, 4U);
  EXPECT_EQ(s.spacings, 2U);
  EXPECT_DOUBLE_EQ(s.mean, 1.0);
}

// Terzaghi's correction makes the frequency along any line the length per area.
TEST(Scanlines, CorrectedFrequencyIsLengthPerArea) {
  SetNumbers set{30.0, 0.0, 1.0, 0.0, 3.0, 1.0, 1.0, 0.5};
  set.law = geometry::SpacingLaw::negexp;
  constexpr int maps = 20;
  for (const double degrees : {0.0, 90.0, 120.0}) {
    double ratio = 0.0;
    for (unsigned seed = 1; seed <= maps; ++seed) {
      const Network n =
          network_of(generated(rectangle(40.0, 30.0), {joint_set(set)}, seed));
      const SpacingStatistics s =
          spacing_statistics(parallel_scanlines(n.window, degrees, 40), n);
      ratio += s.corrected / (n.length() / n.area) / maps;
    }
    EXPECT_NEAR(ratio, 1.0, 0.02) << degrees;
  }
}

// Exponential spacing has the variation 1, constant spacing 0.
TEST(Scanlines, VariationOfTheSpacings) {
  SetNumbers set{0.0, 0.0, 0.25};
  set.law = geometry::SpacingLaw::negexp;
  const Network random =
      network_of(generated(rectangle(5.0, 200.0), {joint_set(set)}, 4));
  const auto lines = parallel_scanlines(random.window, 90.0, 1);
  EXPECT_NEAR(spacing_statistics(lines, random).variation, 1.0, 0.1);
  set.law = geometry::SpacingLaw::uniform;
  const Network even =
      network_of(generated(rectangle(5.0, 200.0), {joint_set(set)}, 4));
  EXPECT_NEAR(spacing_statistics(lines, even).variation, 0.0, 1e-9);
}

}  // namespace
}  // namespace blocks::joints
