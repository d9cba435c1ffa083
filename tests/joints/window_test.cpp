// Chords of windows against areas and widths that are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "joints/window.hpp"

namespace blocks::joints {
namespace {

const geometry::Polygon wide_box = {{0, 0}, {0, 3}, {5, 3}, {5, 0}};
const geometry::Polygon u_shape = {{0, 0}, {0, 10}, {3, 10},  {3, 4},
                                   {7, 4}, {7, 10}, {10, 10}, {10, 0}};

TEST(Window, ChordsOfARectangle) {
  const ChordMeasure flat = chord_measure(wide_box, 0.0);
  EXPECT_DOUBLE_EQ(flat.area, 15.0);
  EXPECT_DOUBLE_EQ(flat.width, 3.0);
  const ChordMeasure slanted = chord_measure(wide_box, 30.0);
  EXPECT_NEAR(slanted.area, 15.0, 1e-12);
  EXPECT_NEAR(slanted.width, 5.0 * 0.5 + 3.0 * std::sqrt(0.75), 1e-12);
}

// Chords along 45 degrees in a unit square: c = sqrt 2 - 2 |t|.
TEST(Window, ChordsFromALengthOn) {
  const geometry::Polygon square = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const double s = 0.5, left = std::numbers::sqrt2 - s;
  const ChordMeasure beyond = chord_measure(square, 45.0, s);
  EXPECT_NEAR(beyond.width, left, 1e-12);
  EXPECT_NEAR(beyond.area, 0.5 * left * left, 1e-12);
  EXPECT_EQ(chord_measure(square, 45.0, 2.0).width, 0.0);
}

TEST(Window, ChordsOfAConcaveWindowCountSeparately) {
  const ChordMeasure flat = chord_measure(u_shape, 0.0);
  EXPECT_NEAR(flat.area, 76.0, 1e-12);
  EXPECT_NEAR(flat.width, 4.0 + 2.0 * 6.0, 1e-12);
  const auto parts = chords(u_shape, {-1, 8}, {1, 0});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_DOUBLE_EQ(parts[0].first, 1.0);
  EXPECT_DOUBLE_EQ(parts[0].second, 4.0);
  EXPECT_DOUBLE_EQ(parts[1].first, 8.0);
}

// A line through a corner, and one along a side.
TEST(Window, LinesThroughCorners) {
  EXPECT_EQ(chords(wide_box, {-1, -0.6}, {5, 3}).size(), 1U);
  EXPECT_LE(chords(wide_box, {-1, 0}, {1, 0}).size(), 1U);
  EXPECT_TRUE(chords(wide_box, {-1, 4}, {1, 0}).empty());
}

}  // namespace
}  // namespace blocks::joints
