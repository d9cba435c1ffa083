// Which polygons lie inside an outline, also against the exact common area.
#include "geometry/region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "area_judge.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

const Polygon square = {{0, 0}, {0, 4}, {4, 4}, {4, 0}};
/// A square of 4 with a notch from the top, between x = 1 and 3, down to y = 1.
const Polygon notched = {{0, 0}, {0, 4}, {1, 4}, {1, 1},
                         {3, 1}, {3, 4}, {4, 4}, {4, 0}};

Polygon box(double x, double y, double w, double h) {
  return {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}};
}

TEST(Region, ContainsWhatTouchesItsOutline) {
  const Region region(square);
  EXPECT_TRUE(region.contains(box(1, 1, 1, 1)));
  EXPECT_TRUE(region.contains(box(0, 1, 1, 1)));
  EXPECT_TRUE(region.contains(square));
  EXPECT_TRUE(Region(reversed(square)).contains(square));
  EXPECT_TRUE(Region(notched).contains(notched));
}

TEST(Region, DoesNotContainWhatReachesOutByOneUnitOfRoundOff) {
  const Region region(square);
  Polygon wide = box(1, 1, 3, 1);
  EXPECT_TRUE(region.contains(wide));
  wide[2].x() = std::nextafter(4.0, 5.0);
  EXPECT_FALSE(region.contains(wide));
  EXPECT_FALSE(region.contains(box(5, 1, 1, 1)));
  EXPECT_FALSE(region.contains(box(-1, -1, 9, 9)));
}

// All corners of the bar are inside, but not the middle of its sides.
TEST(Region, DoesNotContainABarAcrossItsNotch) {
  const Region region(notched);
  EXPECT_FALSE(region.contains(box(0.5, 2, 3, 1)));
  EXPECT_TRUE(region.contains(box(0.5, 0.5, 3, 0.5)));
  // Its upper side runs along the bottom of the notch.
  EXPECT_TRUE(region.contains(box(0, 0, 4, 1)));
  // Two of its sides run along the sides of the notch, and it fills the notch.
  EXPECT_FALSE(region.contains(box(1, 1, 2, 3)));
}

TEST(Region, DoesNotContainWhatHasNoPlace) {
  Polygon lost = box(1, 1, 1, 1);
  lost[2].x() = std::nan("");
  EXPECT_FALSE(Region(square).contains(lost));
  lost[2].x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(Region(square).contains(lost));
}

/// A star-shaped polygon with corners on a grid, so that touches are frequent.
Polygon random_polygon(std::mt19937& random, int corners, double size) {
  std::uniform_real_distribution<double> part(0.3, 1.0);
  std::uniform_int_distribution<int> shift(-4, 4);
  const Vec2 middle(shift(random), shift(random));
  Polygon made;
  for (int i = 0; i < corners; ++i) {
    const double turn = -2.0 * M_PI * i / corners, reach = size * part(random);
    const Vec2 at = middle + reach * Vec2(std::cos(turn), std::sin(turn));
    made.emplace_back(std::round(at.x()), std::round(at.y()));
  }
  return made;
}

// A polygon is inside if the area that it has in common with the region is its own. The
// judge computes areas with rationals of another library, in vertical slabs.
TEST(Region, AgreesWithExactAreas) {
  std::mt19937 random(7);
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Polygon outline = random_polygon(random, 8, 9.0);
    const Polygon block = random_polygon(random, 4, i % 2 == 0 ? 3.0 : 6.0);
    const auto sound = [](const Polygon& p) {
      const OutlineCheck check = check_outline(p);
      return check.fault == OutlineFault::none && !check.anticlockwise;
    };
    if (!sound(outline) || !sound(block))
      continue;
    const bool expected =
        testing::common_area(block, outline) == testing::common_area(block, block);
    EXPECT_EQ(Region(outline).contains(block), expected) << i;
    ++(expected ? inside : outside);
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 200);
}

}  // namespace
}  // namespace blocks::geometry
