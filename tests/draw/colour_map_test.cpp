// Colour maps, and the lines that have to be seen on their colours.
#include "draw/colour_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace blocks::draw {
namespace {

using ::testing::HasSubstr;

TEST(ColourMap, IsMonotoneInLuminanceForMagnitudes) {
  for (const char* name :
       {"ylgnbu", "viridis", "cividis", "grey", "viridis_r", "cividis_r"}) {
    const ColourMap map = colour_map(name);
    const double way = luminance(map.at(1)) - luminance(map.at(0));
    for (int i = 0; i < 50; ++i)
      EXPECT_GT((luminance(map.at((i + 1) / 50.0)) - luminance(map.at(i / 50.0))) * way,
                0.0)
          << name << " " << i;
  }
}

TEST(ColourMap, OfZeroIsLightInGreyAndInViridisReversed) {
  EXPECT_GT(luminance(colour_map("grey").at(0)), 0.7);
  EXPECT_GT(luminance(colour_map("viridis_r").at(0)), 0.7);
  EXPECT_LT(luminance(colour_map("viridis").at(0)), 0.1);
}

TEST(ColourMap, ForSignedQuantitiesIsLightestInTheMiddle) {
  const ColourMap map = colour_map("bluered");
  EXPECT_TRUE(map.diverging);
  EXPECT_GT(luminance(map.at(0.5)), 0.9);
  EXPECT_GT(map.at(0).b, map.at(0).r);
  EXPECT_GT(map.at(1).r, map.at(1).b);
}

TEST(ColourMap, KeepsTheColourOfASignWhateverTheRange) {
  const ColourMap map = colour_map("bluered");
  const auto ends = [&](double low, double high) {
    const ColourMap part = map.for_range(low, high);
    return std::pair(part.first, part.last);
  };
  EXPECT_EQ(ends(-2, 2), std::pair(0.0, 1.0));
  EXPECT_EQ(ends(-2, 1), std::pair(0.0, 0.75));
  EXPECT_EQ(ends(0, 8), std::pair(0.5, 1.0));
  EXPECT_EQ(ends(5, 8), std::pair(0.5, 1.0));
  EXPECT_EQ(ends(-20, -5), std::pair(0.0, 0.5));
}

/// Returns the contrast ratio of two colours, 1 to 21 (WCAG 2).
double contrast(const Colour& a, const Colour& b) {
  const double high = std::max(luminance(a), luminance(b));
  return (high + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

TEST(Outline, IsVisibleOnEveryColour) {
  for (const char* name : {"ylgnbu", "viridis", "cividis", "grey", "bluered"})
    for (int i = 0; i <= 100; ++i) {
      const Colour ground = colour_map(name).at(i / 100.0);
      EXPECT_GT(contrast(ground, outline_on(ground, false)), 2.5) << name << " " << i;
      EXPECT_GT(contrast(ground, outline_on(ground, true)), 1.5) << name << " " << i;
    }
}

// Either the line or its rim differs from the block.
TEST(ContactForce, IsVisibleOnEveryColour) {
  for (const char* name : {"ylgnbu", "viridis", "cividis", "grey", "bluered"})
    for (int i = 0; i <= 20; ++i)
      for (int k = 0; k <= 20; ++k) {
        const Colour ground = colour_map(name).at(i / 20.0), line = intensity(k / 20.0);
        EXPECT_GT(std::max(contrast(ground, line), contrast(ground, rim_of_line(line))),
                  1.8)
            << name << " " << i << " " << k;
      }
}

TEST(ColourMap, IsRefusedIfItsNameIsUnknown) {
  try {
    colour_map("jet");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("viridis, cividis, grey"));
  }
}
}  // namespace
}  // namespace blocks::draw
