#include "geometry/layer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "geometry/overlap.hpp"
#include "layers.hpp"

namespace blocks::geometry {
namespace {

using testing::cell;
using testing::corners;
using testing::decimal;
using ::testing::HasSubstr;
using testing::random_layer;

std::uint64_t fnv(const Mesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const Vec2& v : mesh.vertices) {
    for (const double x : {v.x(), v.y()}) {
      const auto bits = std::bit_cast<std::uint64_t>(x);
      for (int shift = 0; shift < 64; shift += 8) {
        hash = (hash ^ ((bits >> shift) & 0xffU)) * 0x100000001b3ULL;
      }
    }
  }
  return hash;
}

const char* const rectangle = "0 0 0 1 100 1 100 0";

TEST(LayerShape, IsClassifiedFromTheDecimals) {
  EXPECT_EQ(classify_quad(corners("0 0 0 1 1 1 1 0")), QuadShape::convex_clockwise);
  EXPECT_EQ(classify_quad(corners("0 0 1 0 1 1 0 1")), QuadShape::convex_anticlockwise);
  EXPECT_EQ(classify_quad(corners("0 0 1 1 0 1 1 0")), QuadShape::bow_tie);
  EXPECT_EQ(classify_quad(corners("0 0 0 3 1 1 3 0")), QuadShape::dart);
  EXPECT_EQ(classify_quad(corners("0 0 0 0 1 1 1 0")), QuadShape::degenerate);
  // Three corners are on one line as written, but not as doubles.
  EXPECT_EQ(classify_quad(corners("0 0 0.1 0.1 0.3 0.3 1 0")), QuadShape::degenerate);
  EXPECT_EQ(classify_quad(corners("0.1 0.3 0.2 0.6 0.3 0.9 1 0")),
            QuadShape::degenerate);
}

TEST(LayerShape, IsRefusedUnlessConvexAndClockwise) {
  for (const char* quad : {"0 0 1 0 1 1 0 1", "0 0 1 1 0 1 1 0", "0 0 0 3 1 1 3 0",
                           "0.1 0.3 0.2 0.6 0.3 0.9 1 0"}) {
    LayerRequest request;
    request.corners = corners(quad);
    request.count = 2;
    try {
      cut_layer(request);
      FAIL() << quad;
    } catch (const LayerError& error) {
      EXPECT_EQ(error.kind, LayerError::Kind::shape);
      EXPECT_FALSE(error.hint.empty());
    }
  }
}

TEST(EvenLayer, HasEqualBlocksOnTheNearestDoubles) {
  LayerRequest request;
  request.corners = corners("0.1 0.2 0.1 0.7 1.0 0.7 1.0 0.2");
  request.count = 3;
  const Layer layer = cut_layer(request);
  ASSERT_EQ(layer.mesh.cells.size(), 3U);
  EXPECT_TRUE(layer.certificate.holds);
  // These are 0.1 + 0.9 i / 3, rounded once.
  const double x[] = {0.1, 0.4, 0.7, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = cell(layer, i);
    EXPECT_EQ(c[0], Vec2(x[i], 0.2));
    EXPECT_EQ(c[1], Vec2(x[i], 0.7));
    EXPECT_EQ(c[2], Vec2(x[i + 1], 0.7));
    EXPECT_EQ(c[3], Vec2(x[i + 1], 0.2));
  }
}

TEST(LayerShape, IsRefusedIfTooThinForDoubles) {
  // The layer is convex as written. Doubles at 1e17 are 16 apart, so that its blocks
  // vanish.
  LayerRequest request;
  request.corners = corners("1e17 0 1e17 1 100000000000000040 1 100000000000000040 0");
  request.count = 40;
  try {
    cut_layer(request);
    FAIL();
  } catch (const LayerError& error) {
    EXPECT_EQ(error.kind, LayerError::Kind::shape);
    EXPECT_THAT(error.what(), HasSubstr("rounding"));
  }
}

TEST(EvenLayer, KeepsTheFourCornersOfTheDeck) {
  LayerRequest request;
  request.corners = corners("0.1 0.3 -0.7 3.3 90.7 34.1 91.3 31.9");
  request.count = 7;
  const Layer layer = cut_layer(request);
  EXPECT_EQ(cell(layer, 0)[0], Vec2(0.1, 0.3));
  EXPECT_EQ(cell(layer, 0)[1], Vec2(-0.7, 3.3));
  EXPECT_EQ(cell(layer, 6)[2], Vec2(90.7, 34.1));
  EXPECT_EQ(cell(layer, 6)[3], Vec2(91.3, 31.9));
}

/// Returns the text of the point at 0.1 x on the line y = 0.1 a + 0.001 b (0.1 x),
/// raised by 0.1 up. All numbers are decimals.
std::string on_line(int a, int b, int x, int up) {
  char text[80];
  std::snprintf(text, sizeof text, "%.1f %.4f ", 0.1 * x,
                0.1 * (a + up) + 0.0001 * b * x);
  return text;
}

// Layers and a block share a slanted line or an end. Their common corners are the same
// decimals and so the same doubles. shared_corners_test.cpp tests layers that share a
// part of a line.
TEST(Layers, DoNotOverlapAcrossASharedSlantedLine) {
  std::mt19937 engine(5);
  const auto whole = [&engine](int low, int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1));
  };
  for (int k = 0; k < 300; ++k) {
    // Three lines of points in three columns bound four layers around one corner.
    const int b = whole(-999, 999) | 1, x0 = whole(-500, 0), x1 = x0 + whole(50, 400);
    const int x2 = x1 + whole(50, 400), lean = k % 2 == 0 ? 0 : whole(-20, 20);
    const int low = whole(-99, 99), h = whole(45, 60);
    const std::string a0 = on_line(low, b, x0, 0), a1 = on_line(low, b, x1, 0),
                      a2 = on_line(low, b, x2, 0);
    const std::string m0 = on_line(low, b, x0, h), m1 = on_line(low, b, x1 + lean, h),
                      m2 = on_line(low, b, x2, h);
    const std::string t0 = on_line(low, b, x0, 2 * h), t1 = on_line(low, b, x1, 2 * h);
    std::vector<Polygon> blocks;
    const auto cut = [&](const std::string& quad) {
      LayerRequest request;
      request.corners = corners(quad);
      request.count = whole(1, 40);
      const Layer layer = cut_layer(request);
      for (const std::vector<int>& one : layer.mesh.cells)
        blocks.push_back(testing::outline_of(layer.mesh, one));
    };
    cut(a0 + m0 + m1 + a1);
    cut(m0 + t0 + t1 + m1);  // This layer is above the first.
    blocks.push_back({});    // A block is to the right of the first layer.
    for (const DecimalPoint& p : corners(a1 + m1 + m2 + a2))
      blocks.back().emplace_back(p.x.value(), p.y.value());
    EXPECT_TRUE(overlapping_pairs(blocks).empty()) << k;
    blocks.pop_back();
    cut(a1 + m1 + m2 + a2);  // A layer replaces the block.
    EXPECT_TRUE(overlapping_pairs(blocks).empty()) << k;
  }
}

TEST(ListedLayer, ScalesAListThatDoesNotFitItsLine) {
  LayerRequest request;
  request.corners = corners("0 0 0 1 4 4 4 3");  // Both lines are 5 long.
  request.spacing = Spacing::listed;
  request.count = 3;
  request.bottom = {decimal("0.1"), decimal("0.2"), decimal("4.7")};
  request.top = {Decimal(1), Decimal(1), Decimal(2)};
  const Layer layer = cut_layer(request);
  EXPECT_FALSE(layer.bottom_scaled);  // 0.1 + 0.2 + 4.7 is 5 as written.
  EXPECT_TRUE(layer.top_scaled);
  EXPECT_NEAR(cell(layer, 0)[3].x(), 0.08, 1e-15);
  EXPECT_NEAR(cell(layer, 1)[2].x(), 2.0, 1e-15);
}

TEST(ListedLayer, FitsALineOfIrrationalLengthToElevenDigits) {
  LayerRequest request;
  request.corners = corners("0 0 0 1 10 2 10 1");  // Both lines are sqrt(101) long.
  request.spacing = Spacing::listed;
  request.count = 2;
  request.bottom = {Decimal(5), decimal("5.04987562112")};
  request.top = {Decimal(5), decimal("5.0498757")};
  const Layer layer = cut_layer(request);
  EXPECT_FALSE(layer.bottom_scaled);
  EXPECT_TRUE(layer.top_scaled);
}

TEST(ListedLayer, RefusesMissingAndZeroWidths) {
  LayerRequest request;
  request.corners = corners(rectangle);
  request.spacing = Spacing::listed;
  request.count = 2;
  request.bottom = {Decimal(50), Decimal(50)};
  request.top = {Decimal(100), Decimal(0)};
  EXPECT_THROW(cut_layer(request), LayerError);
  request.top = {Decimal(100)};
  EXPECT_THROW(cut_layer(request), LayerError);
}

TEST(RandomLayer, IsTheSameOnEveryMachine) {
  const LayerRequest request =
      random_layer("0.3 -0.1 -0.7 3.2 71.9 9.4 70.2 5.5", 25, "-20", "35");
  EXPECT_EQ(fnv(cut_layer(request).mesh), 11504053028830363664ULL);
}

TEST(RandomLayer, DoesNotDependOnOtherLayers) {
  LayerRequest first = random_layer(rectangle, 60, "-10", "10");
  first.stream = {5, 1};
  const std::uint64_t alone = fnv(cut_layer(first).mesh);
  LayerRequest second = first;
  second.stream.layer = 2;
  EXPECT_NE(fnv(cut_layer(second).mesh), alone);
  EXPECT_EQ(fnv(cut_layer(first).mesh), alone);
}

TEST(RandomLayer, AspectLimitsAreExact) {
  // The length is 2.1 and the height 0.7. With 15 blocks every width/height is exactly
  // 0.2, with one it is exactly 3. In doubles 2.1 / 0.7 is greater than 3.
  const std::string quad = "0 0 0 0.7 2.1 0.7 2.1 0";
  for (const int count : {1, 2, 7, 14, 15}) {
    EXPECT_EQ(cut_layer(random_layer(quad, count)).mesh.cells.size(),
              static_cast<std::size_t>(count));
  }
  const Layer full = cut_layer(random_layer(quad, 15));
  EXPECT_EQ(cell(full, 6)[3].x(), 0.98);  // This is 7 * 0.14, rounded once.
  for (const auto& [narrow, count] :
       {std::pair(quad, 16), std::pair(std::string("0 0 0 0.7 2.11 0.7 2.11 0"), 1)}) {
    try {
      cut_layer(random_layer(narrow, count));
      FAIL() << narrow;
    } catch (const LayerError& error) {
      EXPECT_EQ(error.kind, LayerError::Kind::aspect);
      EXPECT_EQ(error.hint, count == 16 ? "from 1 to 15 blocks are possible"
                                        : "from 2 to 15 blocks are possible");
    }
  }
}

TEST(RandomLayer, IsRefusedIfNoNumberOfBlocksFits) {
  try {
    cut_layer(random_layer("0 0 0 9 1 9 1 0", 1));
    FAIL();
  } catch (const LayerError& error) {
    EXPECT_THAT(error.hint, HasSubstr("no number of blocks"));
  }
}

TEST(RandomLayer, SidesAreNormalToTheMidLineWithoutOrient) {
  // The mid-line runs along (4, 3), so that its normals are along (-3, 4).
  const Layer layer = cut_layer(random_layer("0 0 -3 4 77 64 80 60", 18));
  EXPECT_EQ(layer.ruled, 0);
  for (std::size_t i = 0; i < layer.mesh.cells.size(); ++i) {
    const auto c = cell(layer, i);
    EXPECT_NEAR((c[1] - c[0]).dot(Vec2(4, 3)), 0.0, 1e-11);
  }
}

TEST(RandomLayer, OneAngleTurnsAllSidesAnticlockwiseFromTheNormal) {
  // The top of a side that is turned anticlockwise is to the left of its bottom.
  const Layer layer = cut_layer(random_layer(rectangle, 120, "45", "45"));
  int turned = 0;
  for (std::size_t i = 1; i < layer.mesh.cells.size(); ++i) {
    const auto c = cell(layer, i);
    const Vec2 side = c[1] - c[0];
    EXPECT_LE(side.x(), 0.0);
    turned += std::abs(side.x() + 1.0) < 1e-13 ? 1 : 0;
  }
  // Only the sides next to the ends are ruled, and they do not push others aside.
  EXPECT_EQ(turned, 119 - layer.ruled);
  EXPECT_LT(layer.ruled, 5);
}

TEST(RandomLayer, RefusesAnglesBeyondTheirLimits) {
  for (const auto& [low, high] : {std::pair("-80.1", "0"), std::pair("0", "80.1"),
                                  std::pair("5", "-5"), std::pair("100", "200")}) {
    try {
      cut_layer(random_layer(rectangle, 60, low, high));
      FAIL() << low << ' ' << high;
    } catch (const LayerError& error) {
      EXPECT_EQ(error.kind, LayerError::Kind::angle);
    }
  }
}

TEST(RandomLayer, IsCertifiedForAwkwardQuadrilaterals) {
  std::mt19937 engine(20);
  const auto real = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  int cut = 0;
  int ruled = 0;
  for (int k = 0; k < 400; ++k) {
    // Layers are rotated, slanted or wedge-shaped, at the origin or 1e9 away, with
    // leaning ends.
    const double turn = real(-3.2, 3.2);
    const double length = real(5.0, 200.0);
    const double left = real(0.3, 4.0);
    const double right = k % 3 == 0 ? real(0.01, 4.0) : left;
    const double lean = real(-2.0, 2.0);
    const double offset = k % 4 == 0 ? 1e9 : 0.0;
    const double raw[8] = {0,     0,      lean, left, length + lean * real(-1, 1),
                           right, length, 0};
    std::string quad;
    for (int i = 0; i < 4; ++i) {
      const double x = raw[2 * i] * std::cos(turn) - raw[2 * i + 1] * std::sin(turn);
      const double y = raw[2 * i] * std::sin(turn) + raw[2 * i + 1] * std::cos(turn);
      char text[80];
      std::snprintf(text, sizeof text, "%.4f %.4f ", x + offset, y - offset);
      quad += text;
    }
    if (classify_quad(corners(quad)) != QuadShape::convex_clockwise)
      continue;
    const double height = 0.5 * (left + right);
    const int count = std::max(1, static_cast<int>(length / (height * real(0.3, 2.0))));
    const bool steep = k % 2 == 0;
    LayerRequest request =
        random_layer(quad, count, steep ? "-70" : "-15.5", steep ? "70" : "20");
    request.stream = {1, static_cast<std::uint64_t>(k)};
    if (k % 5 == 0)
      request.merge_ratio = decimal("0.5");
    try {
      const Layer layer = cut_layer(request);
      ASSERT_TRUE(layer.certificate.holds);
      ruled += layer.ruled;
      ++cut;
    } catch (const LayerError& error) {
      if (error.kind == LayerError::Kind::aspect)
        continue;
      FAIL() << k << ": " << error.what() << " | " << error.hint << " | " << quad;
    }
  }
  EXPECT_GT(cut, 300);
  EXPECT_GT(ruled, 0);  // Some sides were ruled as the last resort.
}

TEST(RandomLayer, DoesNotOverlapALayerOnTheSameSlantedLine) {
  // Pairs of upper and lower layer are near the origin and far from it. If corners were
  // rounded to nearest, nearly every pair would overlap by one unit in the last place.
  const std::array<std::pair<const char*, const char*>, 3> pairs = {
      {{"0.1 0.3 0.1 3.4 90.7 34.7 90.7 31.9", "0.1 -2.9 0.1 0.3 90.7 31.9 90.7 28.8"},
       {"-50.1 20.3 -50.2 23.7 50.3 -17.2 50.7 -20.9",
        "-50.3 17.2 -50.1 20.3 50.7 -20.9 50.4 -24.1"},
       {"1000000.1 0.3 1000000.1 3.4 1000090.7 34.7 1000090.7 31.9",
        "1000000.1 -2.9 1000000.1 0.3 1000090.7 31.9 1000090.7 28.8"}}};
  for (const auto& [upper, lower] : pairs) {
    std::vector<Polygon> outlines;
    for (const char* quad : {upper, lower}) {
      LayerRequest request = random_layer(quad, 50, "-20", "20");
      request.stream.layer = outlines.size();
      const Layer layer = cut_layer(request);
      for (const auto& loop : layer.mesh.cells) {
        outlines.push_back(testing::outline_of(layer.mesh, loop));
      }
    }
    EXPECT_TRUE(overlapping_pairs(outlines).empty()) << upper;
  }
}

TEST(RandomLayer, MayHaveThousandsOfBlocks) {
  const LayerRequest wide =
      random_layer("0 0 0.1 1.1 2000.3 31 2000 30", 2000, "-30", "30");
  EXPECT_EQ(cut_layer(wide).mesh.cells.size(), 2000U);
}

}  // namespace
}  // namespace blocks::geometry
