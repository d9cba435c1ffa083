#include "geometry/shared_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <utility>

#include "geometry/layer.hpp"
#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"
#include "layers.hpp"

namespace blocks::geometry {
namespace {

using testing::corners;
using testing::decimal;

/// Dipping strata: bands between parallel slanted lines. Each band is cut into layers
/// at ends of its own, and some layers are single blocks. Corners of a band are inside
/// lines of its neighbours, and layers of two bands share parts of lines.
struct Strata {
  std::vector<DeckOutline> outlines;
  std::vector<int> counts;  ///< blocks of the layer, or 0 for a single block
};

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }

 private:
  std::mt19937 engine_;
};

/// Returns the text of the point at 0.1 x on the line y = 0.1 a + 0.0001 b x, raised by
/// 0.1 up. Coordinates are exchanged if `steep`.
std::string on_line(int a, int b, int x, int up, bool steep) {
  char along[40], across[40];
  std::snprintf(along, sizeof along, "%.1f ", 0.1 * x);
  std::snprintf(across, sizeof across, "%.4f ", 0.1 * (a + up) + 0.0001 * b * x);
  return steep ? std::string(across) + along : std::string(along) + across;
}

Strata strata(Dice& dice, bool leaning, bool steep) {
  Strata result;
  const int a = dice.whole(-99, 99), b = dice.whole(-999, 999) | 1;
  const int west = dice.whole(-500, 0), east = west + dice.whole(300, 900);
  const int bands = dice.whole(2, 5);
  for (int k = 0; k < bands; ++k) {
    const int low = 50 * k, high = 50 * (k + 1);
    int x0 = west, x1 = west;  // These are bottom and top of the left end.
    while (x0 < east) {
      int y0 = std::min(east, x0 + dice.whole(60, 300)), y1 = y0;
      if (east - y0 < 60)
        y0 = y1 = east;
      else if (leaning)
        y1 += dice.whole(-25, 25);
      std::string quad = on_line(a, b, x0, low, steep) +
                         on_line(a, b, x1, high, steep) +
                         on_line(a, b, y1, high, steep) + on_line(a, b, y0, low, steep);
      auto four = corners(quad);
      if (steep)  // The mirror image of a clockwise layer is anticlockwise.
        std::swap(four[1], four[3]);
      result.outlines.push_back({{four.begin(), four.end()}, {}, 1});
      result.counts.push_back(dice.whole(0, 3) == 0 ? 0 : dice.whole(1, 30));
      x0 = y0, x1 = y1;
    }
  }
  return result;
}

std::vector<Polygon> cut(const Strata& strata, const SharedCorners& shared) {
  std::vector<Polygon> blocks;
  for (std::size_t i = 0; i < strata.outlines.size(); ++i) {
    LayerRequest request;
    request.rounded.emplace();
    for (std::size_t c = 0; c < 4; ++c) {
      const DecimalPoint& corner = strata.outlines[i].corners[c];
      request.corners[c] = corner;
      (*request.rounded)[c] = shared.place({corner.x.value(), corner.y.value()});
    }
    if (strata.counts[i] == 0) {
      blocks.emplace_back(request.rounded->begin(), request.rounded->end());
      continue;
    }
    request.count = strata.counts[i];
    const Layer layer = cut_layer(request);
    for (const std::vector<int>& cell : layer.mesh.cells)
      blocks.push_back(testing::outline_of(layer.mesh, cell));
  }
  return blocks;
}

TEST(SharedCorners, KeepLayersOnPartsOfASlantedLineApart) {
  std::size_t moved = 0, crossed = 0;
  for (unsigned k = 0; k < 200; ++k) {
    Dice dice(k);
    const Strata made = strata(dice, k % 2 == 1, k % 4 >= 2);
    const SharedCorners shared(made.outlines);
    moved += shared.moved();
    EXPECT_TRUE(overlapping_pairs(cut(made, shared)).empty()) << k;
    crossed += overlapping_pairs(cut(made, {})).size();
  }
  EXPECT_GT(moved, 100U);    // Some corners have to move.
  EXPECT_GT(crossed, 100U);  // Blocks overlap unless they do.
}

TEST(SharedCorners, DoNotDependOnOrderSenseAndOtherOutlines) {
  Dice dice(11);
  const Strata made = strata(dice, true, false);
  const SharedCorners shared(made.outlines);
  ASSERT_GT(shared.moved(), 0U);
  auto other = made.outlines;
  std::reverse(other.begin(), other.end());
  for (DeckOutline& outline : other)
    std::reverse(outline.corners.begin(), outline.corners.end());
  const auto far = corners("1000 1000 1000 1010 1020 1011 1020 1003");
  other.push_back({{far.begin(), far.end()}, {decimal("0.1"), decimal("30.7")}, 3});
  const SharedCorners again(other);
  EXPECT_EQ(again.moved(), shared.moved());
  for (const DeckOutline& outline : made.outlines)
    for (const DecimalPoint& corner : outline.corners) {
      const Vec2 nearest(corner.x.value(), corner.y.value());
      EXPECT_EQ(again.place(nearest), shared.place(nearest));
      EXPECT_LT((shared.place(nearest) - nearest).norm(), 1e-12);
    }
}

TEST(SharedCorners, KeepCopiesOfABlockApartFromALine) {
  // One block is above a line of slope 1 : 3, and copies of another hang below it.
  const auto slope = corners("0 0 0 20 33.3 20 33.3 11.1");
  const auto block = corners("0.7 -9 0.3 0.1 1.2 0.4 1.2 -9");
  DeckOutline copies{
      {block.begin(), block.end()}, {decimal("0.9"), decimal("0.3")}, 30};
  const SharedCorners shared({{{slope.begin(), slope.end()}, {}, 1}, copies});
  std::vector<Polygon> blocks(1);
  for (const DecimalPoint& p : slope)
    blocks[0].push_back(shared.place({p.x.value(), p.y.value()}));
  for (int copy = 0; copy < copies.copies; ++copy) {
    Polygon outline = place_outline(copies.corners, copies.shift, copy);
    for (Vec2& corner : outline)
      corner = shared.place(corner);
    blocks.push_back(std::move(outline));
  }
  EXPECT_GT(shared.moved(), 0U);
  for (std::size_t i = 1; i < blocks.size(); ++i)
    EXPECT_TRUE(overlapping_pairs({blocks[0], blocks[i]}).empty()) << i;
}

// The line falls by 1e-10. A corner that moved horizontally would have to move far to
// leave it.
TEST(SharedCorners, MoveNoCornerFartherThanRounding) {
  const auto layer = corners("0 100.3 0 101.3 30 101.300000003 30 100.3");
  const auto block =
      corners("5.99998 101.3000000006 5.99998 102.3 7 102.3 6 101.3000000006");
  const SharedCorners shared(
      {{{layer.begin(), layer.end()}, {}, 1}, {{block.begin(), block.end()}, {}, 1}});
  for (const DecimalPoint& p : block) {
    const Vec2 nearest(p.x.value(), p.y.value());
    EXPECT_LT((shared.place(nearest) - nearest).norm(), 200.0 * 0x1p-52 * 102.3);
  }
}

TEST(SharedCorners, DoNotMoveOnLinesAlongAnAxis) {
  // The corner (5, 0) of the slanted layer is inside the horizontal top of the left
  // one. The corner (10, 0) of the left one is inside no line.
  const auto left = corners("0 -5 0 0 10 0 10 -5"), right = corners("5 0 4 9 9 9 10 0");
  EXPECT_EQ(SharedCorners({{{left.begin(), left.end()}, {}, 1},
                           {{right.begin(), right.end()}, {}, 1}})
                .moved(),
            0U);
}

}  // namespace
}  // namespace blocks::geometry
