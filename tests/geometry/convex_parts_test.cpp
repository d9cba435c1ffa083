// Properties of the convex parts of an outline that the contact rule relies on.
#include "geometry/convex_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"
#include "validation/geometry/contact_draw.hpp"

namespace blocks::geometry {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Parts = std::vector<std::vector<int>>;
using validation::Draw;

/// Returns twice the area of the triangle a, b, c, negative if it is clockwise.
Rational turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Rational ax(a.x()), ay(a.y());
  return (Rational(b.x()) - ax) * (Rational(c.y()) - ay) -
         (Rational(b.y()) - ay) * (Rational(c.x()) - ax);
}

Rational twice_area(const Polygon& p) {
  Rational area = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    area -= turn(p[0], p[i], p[i + 1]);
  return area;
}

std::string text(const Polygon& outline) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Vec2& corner : outline)
    out << "(" << corner.x() << ", " << corner.y() << ") ";
  return out.str();
}

/// Requires that the parts are convex, clockwise and disjoint and fill the outline.
/// Each of their sides is an edge of the outline, or an inner side. Another part has
/// the same inner side in the opposite direction.
void expect_tiling(const Polygon& outline) {
  const Parts parts = convex_parts(outline);
  SCOPED_TRACE(text(outline));
  ASSERT_FALSE(parts.empty());
  const bool anticlockwise = check_outline(outline).anticlockwise;
  const auto size = static_cast<int>(outline.size());
  std::map<std::pair<int, int>, int> sides;
  std::vector<Polygon> polygons;
  Rational area = 0;
  for (const std::vector<int>& part : parts) {
    Polygon& p = polygons.emplace_back();
    for (const int corner : part) {
      ASSERT_TRUE(corner >= 0 && corner < size);
      p.push_back(outline[static_cast<std::size_t>(corner)]);
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t j = (i + 1) % part.size(), k = (i + 2) % part.size();
      EXPECT_LE(turn(p[i], p[j], p[k]), 0);
      ++sides[{part[i], part[j]}];
    }
    const OutlineCheck check = check_outline(p);
    EXPECT_EQ(check.fault, OutlineFault::none);
    EXPECT_TRUE(check.convex && !check.anticlockwise);
    EXPECT_GT(twice_area(p), 0);
    area += twice_area(p);
  }
  EXPECT_EQ(area, abs(twice_area(outline)));
  EXPECT_TRUE(overlapping_pairs(polygons, {}, Figures::quick).empty());
  int edges = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    const auto [start, end] = side;
    const bool is_edge =
        anticlockwise ? (end + 1) % size == start : (start + 1) % size == end;
    edges += is_edge;
    EXPECT_EQ(sides.contains({end, start}), !is_edge) << start << ' ' << end;
  }
  EXPECT_EQ(edges, size);
  ASSERT_FALSE(testing::Test::HasFailure());
}

/// Tests the outline in both senses, beginning with each of its corners.
void expect_tiling_for_all_orders(Polygon outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    ASSERT_NO_FATAL_FAILURE(expect_tiling(outline));
    ASSERT_NO_FATAL_FAILURE(expect_tiling(reversed(outline)));
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
  }
}

/// Adds a straight corner in the middle of every side where the middle is exact.
Polygon with_straight_corners(const Polygon& outline) {
  Polygon result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const Vec2 middle = 0.5 * (a + b);
    result.push_back(a);
    if (turn(a, middle, b) == 0)
      result.push_back(middle);
  }
  return result;
}

Polygon comb(int teeth) {
  Polygon p{{0, 0}};
  for (int i = 0; i < teeth; ++i)
    for (const Vec2& v : {Vec2(0, 3), Vec2(1, 3), Vec2(1, 1), Vec2(2, 1)})
      p.push_back(v + Vec2(2 * i, 0));
  p.push_back(Vec2(2 * teeth, 0));
  return p;
}

Polygon star(int tips) {
  Polygon p;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = -std::numbers::pi * i / tips;
    p.push_back((i % 2 ? 1 : 3) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return p;
}

/// A square spiral, one unit wide, with gaps one unit wide.
Polygon spiral(int turns) {
  Polygon outer, inner;
  Vec2 at(0, 0), inside(1, 1);
  for (int i = 0; i < 4 * turns; ++i) {
    const double length = 4 * turns + 3 - 2 * (i / 2);
    const Vec2 way = i % 4 == 0   ? Vec2(0, 1)
                     : i % 4 == 1 ? Vec2(1, 0)
                     : i % 4 == 2 ? Vec2(0, -1)
                                  : Vec2(-1, 0);
    at += length * way;
    outer.push_back(at);
    inner.push_back(at - way + Vec2(way.y(), -way.x()));
  }
  Polygon p{{0, 0}};
  p.insert(p.end(), outer.begin(), outer.end());
  p.insert(p.end(), inner.rbegin(), inner.rend());
  p.push_back({1, 0});
  return p;
}

TEST(ConvexParts, TileTextbookShapes) {
  const Polygon l{{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}};
  const Polygon u{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}};
  const Polygon cross{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {2, 2},
                      {3, 2}, {3, 1}, {2, 1}, {2, 0}, {1, 0}, {1, 1}};
  for (const Polygon& outline :
       {l, u, cross, comb(6), star(5), star(8), spiral(1), spiral(3)}) {
    ASSERT_EQ(check_outline(outline).fault, OutlineFault::none) << text(outline);
    ASSERT_FALSE(check_outline(outline).convex) << text(outline);
    ASSERT_NO_FATAL_FAILURE(expect_tiling_for_all_orders(outline));
    ASSERT_NO_FATAL_FAILURE(
        expect_tiling_for_all_orders(with_straight_corners(outline)));
  }
  ASSERT_NO_FATAL_FAILURE(expect_tiling(comb(80)));
  EXPECT_EQ(convex_parts(l).size(), 2U);
  EXPECT_EQ(convex_parts(u).size(), 3U);
}

TEST(ConvexParts, KeepConvexOutlinesWhole) {
  const Polygon square{{0, 0}, {0, 2}, {2, 2}, {2, 1}, {2, 0}};
  EXPECT_EQ(convex_parts(square), (Parts{{0, 1, 2, 3, 4}}));
  // The part of an anticlockwise outline is clockwise.
  Polygon back = square;
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(convex_parts(back), (Parts{{4, 3, 2, 1, 0}}));
  ASSERT_NO_FATAL_FAILURE(expect_tiling_for_all_orders(square));
}

TEST(ConvexParts, DoNotExistForFaultyOutlines) {
  const double nan = std::nan("");
  for (const Polygon& faulty :
       {Polygon{}, Polygon{{0, 0}, {1, 1}}, Polygon{{0, 0}, {1, 1}, {2, 2}},
        Polygon{{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}},
        Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, Polygon{{0, 0}, {0, nan}, {1, 0}}})
    EXPECT_TRUE(convex_parts(faulty).empty()) << text(faulty);
}

/// Returns the outline of a simply connected set of lattice cells. Each lattice point
/// on it is a corner.
Polygon around_cells(Draw& draw) {
  constexpr int n = 5;
  for (;;) {
    bool cell[n + 2][n + 2] = {};
    int x = n / 2 + 1, y = n / 2 + 1;
    for (int i = draw.whole(3, 30); i > 0; --i) {
      cell[x][y] = true;
      (draw.coin() ? x : y) += draw.coin() ? 1 : -1;
      x = std::clamp(x, 1, n), y = std::clamp(y, 1, n);
    }
    // These are unit edges, clockwise around the cells. A simple outline has one edge
    // per lattice point.
    std::map<std::pair<int, int>, std::pair<int, int>> next;
    int edges = 0;
    for (x = 1; x <= n; ++x)
      for (y = 1; y <= n; ++y)
        if (cell[x][y]) {
          if (!cell[x - 1][y])
            next[{x, y}] = {x, y + 1}, ++edges;
          if (!cell[x][y + 1])
            next[{x, y + 1}] = {x + 1, y + 1}, ++edges;
          if (!cell[x + 1][y])
            next[{x + 1, y + 1}] = {x + 1, y}, ++edges;
          if (!cell[x][y - 1])
            next[{x + 1, y}] = {x, y}, ++edges;
        }
    Polygon outline;
    std::pair<int, int> at = next.begin()->first;
    do {
      outline.emplace_back(at.first, at.second);
      at = next.at(at);
    } while (at != next.begin()->first && static_cast<int>(outline.size()) <= edges);
    if (static_cast<int>(outline.size()) == edges)
      return outline;
  }
}

Polygon without_some_straight_corners(Draw& draw, const Polygon& outline) {
  Polygon kept = outline;
  for (std::size_t i = 0; i < kept.size();) {
    const std::size_t n = kept.size();
    if (turn(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n]) == 0 && draw.coin())
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return kept;
}

// Outlines on a lattice have many collinear corners, on one side and across the
// outline.
TEST(ConvexParts, TileOutlinesOnALattice) {
  Draw draw(1, 1);
  int inner = 0;
  for (int n = 0; n < 3000; ++n) {
    Polygon p = without_some_straight_corners(draw, around_cells(draw));
    const double shear = draw.whole(-3, 3), stretch = draw.whole(1, 4);
    for (Vec2& v : p)
      v.x() = stretch * v.x() + shear * v.y();
    inner += convex_parts(p).size() > 1;
    ASSERT_NO_FATAL_FAILURE(expect_tiling(n % 2 ? p : reversed(p))) << n;
  }
  EXPECT_GT(inner, 2000);
}

/// Returns a simple outline of random corners: ends of crossing sides are exchanged
/// until no sides cross.
Polygon uncrossed(Draw& draw, int corners, bool lattice) {
  for (;;) {
    Polygon p;
    for (int i = 0; i < corners; ++i)
      p.push_back(lattice ? Vec2(draw.whole(0, 6), draw.whole(0, 6)) : draw.vector(1));
    for (int step = 0; step < 500; ++step) {
      const OutlineCheck check = check_outline(p);
      if (check.fault == OutlineFault::none)
        return check.anticlockwise ? reversed(p) : p;
      if (check.fault != OutlineFault::self_crossing)
        break;
      std::reverse(p.begin() + check.first + 1, p.begin() + check.second + 1);
    }
  }
}

TEST(ConvexParts, TileRandomOutlines) {
  Draw draw(2, 1);
  int inner = 0;
  for (int n = 0; n < 3000; ++n) {
    Polygon p = uncrossed(draw, draw.whole(4, 12), n % 2 == 0);
    if (n % 4 < 2)
      p = with_straight_corners(p);
    if (n % 8 >= 6) {  // Straight corners and their lines are rounded.
      const double angle = draw.uniform(0, 6.3), c = std::cos(angle),
                   s = std::sin(angle);
      const Vec2 shift = draw.vector(1000);
      for (Vec2& v : p)
        v = shift + Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y());
      if (check_outline(p).fault != OutlineFault::none)
        continue;
    }
    inner += convex_parts(p).size() > 1;
    ASSERT_NO_FATAL_FAILURE(expect_tiling(n % 2 ? p : reversed(p))) << n;
  }
  EXPECT_GT(inner, 2000);
}

}  // namespace
}  // namespace blocks::geometry
