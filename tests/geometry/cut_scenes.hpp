// Helpers of the tests of cutting: outlines and joints in short form, and a slow exact
// judge of the result.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/cut.hpp"
#include "geometry/joint_sources.hpp"
#include "tests/geometry/area_judge.hpp"

namespace blocks::geometry::testing {

inline Decimal number(const std::string& text) {
  const auto value = Decimal::parse(text);
  if (!value)
    throw std::invalid_argument("not a decimal: " + text);
  return *value;
}

/// Reads points from "x1 y1 x2 y2 ...".
inline std::vector<DecimalPoint> points(const std::string& text) {
  std::istringstream in(text);
  std::vector<DecimalPoint> result;
  for (std::string x, y; in >> x >> y;)
    result.push_back({number(x), number(y)});
  return result;
}

/// Reads joints from "x1 y1 x2 y2" each, all with one id.
inline std::vector<JointSegment> joints(const std::string& text, int id = 1) {
  const auto ends = points(text);
  std::vector<JointSegment> result;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    result.push_back({ends[i], ends[i + 1], id});
  return result;
}

inline CutRequest request(const std::string& outline, std::vector<JointSegment> cuts) {
  CutRequest result;
  result.outline = points(outline);
  result.joints = std::move(cuts);
  return result;
}

inline const std::string ten = "0 0 0 10 10 10 10 0";

inline Polygon polygon(const Mesh& mesh, const std::vector<int>& loop) {
  Polygon result;
  for (const int v : loop)
    result.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  return result;
}

/// Twice the area of a clockwise polygon, exactly.
inline Exact twice_area(const Polygon& p) {
  Exact sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += Exact(b.x()) * Exact(a.y()) - Exact(a.x()) * Exact(b.y());
  }
  return sum;
}

/// Judges a result without predicates of the library: all areas are positive, those of
/// the cells add up to that of the outline, and no two cells or blocks overlap.
inline void expect_tiling(const CutResult& result) {
  const Mesh& mesh = result.mesh;
  Exact sum = 0;
  std::vector<Polygon> cells, blocks;
  for (const auto& cell : mesh.cells) {
    cells.push_back(polygon(mesh, cell));
    EXPECT_GT(twice_area(cells.back()), 0);
    sum += twice_area(cells.back());
  }
  EXPECT_EQ(sum, twice_area(polygon(mesh, mesh.outline)));
  ASSERT_EQ(result.blocks.size(), cells.size());
  ASSERT_EQ(result.joints.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(result.joints[i].size(), cells[i].size());
    EXPECT_EQ(result.blocks[i].joints.size(), result.blocks[i].corners.size());
    blocks.push_back(polygon(mesh, result.blocks[i].corners));
    EXPECT_LE(twice_area(blocks.back()), twice_area(cells[i]));
  }
  for (const auto* set : {&cells, &blocks})
    for (std::size_t i = 0; i < set->size(); ++i)
      for (std::size_t j = i + 1; j < set->size(); ++j) {
        Vec2 low(-HUGE_VAL, -HUGE_VAL), high(HUGE_VAL, HUGE_VAL);
        for (const Polygon* p : {&(*set)[i], &(*set)[j]}) {
          Vec2 a = p->front(), b = a;
          for (const Vec2& corner : *p) {
            a = a.cwiseMin(corner);
            b = b.cwiseMax(corner);
          }
          low = low.cwiseMax(a);
          high = high.cwiseMin(b);
        }
        if ((low.array() < high.array()).all()) {
          EXPECT_EQ(common_area((*set)[i], (*set)[j]), 0) << i << " and " << j;
        }
      }
}

/// The places of all blocks and the joints of their sides, as text that is equal only
/// if every bit is.
inline std::string bits(const CutResult& result) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Vec2& v : result.mesh.vertices)
    out << v.x() << ' ' << v.y() << '\n';
  for (std::size_t i = 0; i < result.blocks.size(); ++i) {
    for (const auto* list : {&result.mesh.cells[i], &result.joints[i],
                             &result.blocks[i].corners, &result.blocks[i].joints}) {
      for (const int v : *list)
        out << v << ' ';
      out << '/';
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace blocks::geometry::testing
