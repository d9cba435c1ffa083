// Cutting a domain along joints: exact counts, report, ids, cleaning, errors.
#include "geometry/cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::bits;
using testing::Exact;
using testing::expect_tiling;
using testing::joints;
using testing::request;
using testing::ten;
using testing::twice_area;

double area(const CutResult& result, std::size_t cell) {
  return static_cast<double>(
      twice_area(testing::polygon(result.mesh, result.mesh.cells[cell])) / 2);
}

std::string cut_fault(const CutRequest& request, CutError::Kind kind) {
  try {
    cut_outline(request);
  } catch (const CutError& error) {
    EXPECT_EQ(error.kind, kind);
    EXPECT_FALSE(error.hint.empty());
    EXPECT_TRUE(error.place.allFinite());
    return error.what();
  }
  return "no fault";
}

// Random joints with ends in doubles about the square of side 10.
std::vector<JointSegment> random_joints(int count, double length, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<JointSegment> result;
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * part(random);
    const Vec2 p(10.0 * part(random), 10.0 * part(random));
    const Vec2 d(length * std::cos(angle), length * std::sin(angle));
    result.push_back({Vec2(p - d), Vec2(p + d), i % 4});
  }
  return result;
}

// Counts the crossings inside a convex clockwise outline by rationals of Boost.
int inner_crossings(const std::vector<JointSegment>& lines, const Polygon& outline) {
  const auto cross = [](const Exact& ax, const Exact& ay, const Exact& bx,
                        const Exact& by) { return Exact(ax * by - ay * bx); };
  int count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const Vec2 a = lines[i].from.nearest(), b = lines[i].to.nearest();
      const Vec2 c = lines[j].from.nearest(), d = lines[j].to.nearest();
      const Exact ux = Exact(b.x()) - Exact(a.x()), uy = Exact(b.y()) - Exact(a.y());
      const Exact vx = Exact(d.x()) - Exact(c.x()), vy = Exact(d.y()) - Exact(c.y());
      const Exact wx = Exact(c.x()) - Exact(a.x()), wy = Exact(c.y()) - Exact(a.y());
      const Exact s = cross(wx, wy, vx, vy) / cross(ux, uy, vx, vy);
      const Exact x = Exact(a.x()) + s * ux, y = Exact(a.y()) + s * uy;
      bool inside = true;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
        inside =
            inside && cross(Exact(q.x()) - Exact(p.x()), Exact(q.y()) - Exact(p.y()),
                            x - Exact(p.x()), y - Exact(p.y())) < 0;
      }
      count += inside ? 1 : 0;
    }
  return count;
}

TEST(CutOutline, WithoutJointsIsOneBlock) {
  const CutResult result = cut_outline(request(ten, {}));
  EXPECT_EQ(result.mesh.cells.size(), 1U);
  EXPECT_EQ(result.blocks[0].corners.size(), 4U);
  EXPECT_EQ(result.report.faces, 1U);
  EXPECT_EQ(result.report.components, 1U);
}

// Each line adds a face, and so does each crossing (Euler's formula).
TEST(CutOutline, LinesInGeneralPositionMakeOneFacePerLineAndCrossing) {
  for (const std::string& outline : {ten, std::string("0 3 2 10 9 9 10 4 6 0")})
    for (unsigned seed = 0; seed < 12; ++seed) {
      const int n = 3 + static_cast<int>(seed);
      CutRequest lines = request(outline, random_joints(n, 40.0, seed));
      Polygon corners;
      for (const DecimalPoint& p : lines.outline)
        corners.emplace_back(p.x.value(), p.y.value());
      // Lines of random joints pass through the square, but may miss the pentagon.
      int passing = 0;
      for (const JointSegment& line : lines.joints) {
        const Vec2 a = line.from.nearest(), d = line.to.nearest() - a;
        bool left = false, right = false;
        for (const Vec2& corner : corners)
          (cross(d, corner - a) > 0.0 ? left : right) = true;
        passing += left && right ? 1 : 0;
      }
      const CutResult result = cut_outline(lines);
      EXPECT_EQ(static_cast<int>(result.mesh.cells.size()),
                1 + passing + inner_crossings(lines.joints, corners));
      EXPECT_EQ(result.report.pruned_edges, 0U);
      expect_tiling(result);
    }
}

// Cells of points in general position meet in threes.
TEST(CutOutline, VoronoiCellsHaveTheNumberOfVerticesOfEulersFormula) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    VoronoiRequest cells;
    cells.count = 30;
    cells.lloyd = static_cast<int>(seed % 3);
    cells.stream = {seed, 7};
    cells.id = 3;
    for (const std::string& outline : {ten, std::string("0 0 0 10 5 4 10 10 10 0")}) {
      CutRequest all = request(outline, {});
      all.joints = voronoi_cells(cells, all.outline).edges;
      const CutResult result = cut_outline(all);
      const std::size_t faces = result.mesh.cells.size();
      const std::size_t nodes = result.mesh.outline.size() - all.outline.size();
      const std::size_t inner =
          result.mesh.vertices.size() - result.mesh.outline.size();
      EXPECT_EQ(inner, 2 * (faces - 1) - nodes);
      EXPECT_GE(faces, 30U);
      expect_tiling(result);
    }
  }
}

TEST(CutOutline, TraceWithOneFreeEndIsPruned) {
  const CutResult result = cut_outline(request(ten, joints("0 5 9 5", 4)));
  EXPECT_EQ(result.mesh.cells.size(), 1U);
  EXPECT_DOUBLE_EQ(result.report.lengths.at(4).pruned, 9.0);
  EXPECT_DOUBLE_EQ(result.report.p21_before, 0.09);
  EXPECT_DOUBLE_EQ(result.report.p21_after, 0.0);
  // The vertex where the trace met the outline is gone as well.
  EXPECT_EQ(result.mesh.vertices.size(), 4U);
}

TEST(CutOutline, ProlongedTraceHalvesTheSquare) {
  CutRequest square = request(ten, joints("0 5 9 5", 4));
  const Prolongation traces = prolonged(square.joints, Decimal(1), {}, square.outline);
  EXPECT_EQ(traces.ends, 1U);
  EXPECT_DOUBLE_EQ(traces.largest, 1.0);
  square.joints = traces.traces;
  const CutResult result = cut_outline(square);
  ASSERT_EQ(result.mesh.cells.size(), 2U);
  EXPECT_EQ(area(result, 0), 50.0);
  EXPECT_EQ(area(result, 1), 50.0);
}

// The decimals 0.3 and 9.7 are not doubles; the trace still bisects the square.
TEST(CutOutline, SlantedTraceBisectsTheSquareAndMovesNothing) {
  const CutResult result = cut_outline(request(ten, joints("0.3 0 9.7 10")));
  ASSERT_EQ(result.mesh.cells.size(), 2U);
  for (const Vec2& end : {Vec2(0.3, 0.0), Vec2(9.7, 10.0)})
    EXPECT_NE(std::find(result.mesh.vertices.begin(), result.mesh.vertices.end(), end),
              result.mesh.vertices.end());
  EXPECT_NEAR(area(result, 0), 50.0, 1e-13);
  EXPECT_NEAR(area(result, 1), 50.0, 1e-13);
  EXPECT_EQ(result.report.moved_t_vertices + result.report.contractions, 0U);
}

TEST(CutOutline, IslandsAndLoopsAtOneVertexAreAbsorbed) {
  // A closed triangle inside, a triangle that hangs from the outline at (0, 5), and a
  // triangle on a bridge.
  const CutResult result =
      cut_outline(request(ten, joints("4 4 6 4 6 4 5 6 5 6 4 4 "
                                      "0 5 2 6 2 6 2 4 2 4 0 5 "
                                      "10 5 9 5 9 5 8 6 8 6 8 4 8 4 9 5")));
  EXPECT_EQ(result.mesh.cells.size(), 1U);
  EXPECT_EQ(result.report.faces, 4U);
  EXPECT_EQ(result.report.components, 2U);
  EXPECT_EQ(result.report.islands, 1U);
  EXPECT_EQ(result.report.pinched_loops, 2U);
  EXPECT_EQ(result.report.absorbed_faces, 3U);
}

TEST(CutOutline, WhatIsOutsideIsDropped) {
  const std::string notched = "0 0 0 10 4 10 4 4 6 4 6 10 10 10 10 0";
  const CutResult result = cut_outline(request(notched, joints("-5 7 15 7")));
  EXPECT_EQ(result.mesh.cells.size(), 3U);
  EXPECT_DOUBLE_EQ(result.report.lengths.at(1).drawn, 8.0);
  expect_tiling(result);
}

TEST(CutOutline, OverlappingJointsHaveTheSmallestIdThatIsNotZero) {
  auto cuts = joints("0 5 10 5", 7);
  for (const auto& more : {joints("2 5 8 5", 3), joints("2 5 8 5", 0)})
    cuts.insert(cuts.end(), more.begin(), more.end());
  const CutResult result = cut_outline(request(ten, cuts));
  ASSERT_EQ(result.mesh.cells.size(), 2U);
  // The vertices at 2 and 8 remain, because the id changes there.
  EXPECT_EQ(result.mesh.cells[0].size(), 6U);
  std::multiset<int> ids(result.joints[0].begin(), result.joints[0].end());
  EXPECT_EQ(ids, (std::multiset<int>{0, 0, 0, 3, 7, 7}));
}

TEST(CutOutline, TwinsHaveTheSameJoint) {
  const CutResult result = cut_outline(request(ten, random_joints(40, 3.0, 5)));
  std::map<std::pair<int, int>, int> joint_of;
  for (std::size_t c = 0; c < result.mesh.cells.size(); ++c) {
    const auto& cell = result.mesh.cells[c];
    for (std::size_t i = 0; i < cell.size(); ++i)
      joint_of[{cell[i], cell[(i + 1) % cell.size()]}] = result.joints[c][i];
  }
  for (const auto& [edge, joint] : joint_of) {
    const auto twin = joint_of.find({edge.second, edge.first});
    EXPECT_TRUE(twin == joint_of.end() ? joint == 0 : twin->second == joint);
  }
}

TEST(CutOutline, OrderAndDirectionOfJointsHaveNoEffect) {
  for (const double clean : {0.0, 0.3}) {
    CutRequest cuts = request("0 0 1 9 10 10 9 1", random_joints(60, 3.0, 11));
    cuts.emin = clean;
    cuts.amin = clean * clean;
    const std::string before = bits(cut_outline(cuts));
    std::mt19937_64 random(2);
    for (int i = 0; i < 5; ++i) {
      std::shuffle(cuts.joints.begin(), cuts.joints.end(), random);
      for (JointSegment& joint : cuts.joints)
        if (random() % 2 == 0)
          std::swap(joint.from, joint.to);
      EXPECT_EQ(bits(cut_outline(cuts)), before);
    }
  }
}

// The side of the upper block has a T vertex, which the block does not keep.
TEST(CutOutline, TVertexIsNoCornerOfTheBlockWithTheStraightSide) {
  const CutResult result =
      cut_outline(request(ten, joints("0 3.3 10 6.1 5.1 0 5.1 9")));
  ASSERT_EQ(result.blocks.size(), 3U);
  EXPECT_EQ(result.report.t_vertices, 1U);
  EXPECT_EQ(result.report.kept_t_vertices, 0U);
  for (const CutBlock& block : result.blocks)
    EXPECT_EQ(block.corners.size(), 4U);
  expect_tiling(result);
}

TEST(CutOutline, VerticesOnSlantedSidesAreInsideTheDomain) {
  const CutRequest cuts =
      request("0.1 0.2 0.7 9.3 10.1 10.3 9.9 0.7", random_joints(40, 40.0, 3));
  const CutResult result = cut_outline(cuts);
  const Mesh& mesh = result.mesh;
  Polygon corners;
  for (const DecimalPoint& p : cuts.outline)
    corners.emplace_back(p.x.value(), p.y.value());
  Polygon outside;  // a block on the other side of the left side, with the same corners
  outside = {corners[1], corners[0], {-5.0, 0.0}, {-5.0, 10.0}};
  for (const auto& cell : mesh.cells)
    EXPECT_EQ(testing::common_area(outside, testing::polygon(mesh, cell)), 0);
}

TEST(CutOutline, ShortEdgesAreContracted) {
  // Three lines that nearly meet in one point make a small triangle.
  CutRequest cuts = request(ten, joints("0 5 10 5 5 0 5 10 0.001 0 10 9.999"));
  EXPECT_EQ(cut_outline(cuts).mesh.cells.size(), 7U);
  cuts.emin = 0.01;
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(result.mesh.cells.size(), 6U);
  EXPECT_EQ(result.report.kept_short, 0U);
  EXPECT_GE(result.report.contractions, 2U);
  EXPECT_GT(result.report.largest_move, 0.0);
  EXPECT_LT(result.report.largest_move, 0.01);
  expect_tiling(result);
}

TEST(CutOutline, SmallCellsAreMergedAlongTheLongestChain) {
  // A strip of width 0.01 beside the left half.
  CutRequest cuts = request(ten, joints("5 0 5 10 5.01 0 5.01 10 5.01 5 10 5", 2));
  EXPECT_EQ(cut_outline(cuts).mesh.cells.size(), 4U);
  cuts.amin = 0.2;
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(result.mesh.cells.size(), 3U);
  EXPECT_EQ(result.report.merges, 1U);
  EXPECT_EQ(result.report.kept_small, 0U);
  // Vertices of the removed side are gone.
  EXPECT_EQ(result.mesh.vertices.size(), 8U);
  expect_tiling(result);
}

TEST(CutOutline, CleaningKeepsTheCornersOfTheOutline) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CutRequest cuts =
        request("0 0 0 10 0.1 10 10 10 10 0", random_joints(60, 2.5, seed));
    cuts.emin = 0.8;
    cuts.amin = 1.0;
    const CutResult result = cut_outline(cuts);
    EXPECT_EQ(area(cut_outline(request(ten, {})), 0),
              static_cast<double>(
                  twice_area(testing::polygon(result.mesh, result.mesh.outline)) / 2));
    for (std::size_t c = 0; c < result.mesh.cells.size(); ++c)
      EXPECT_TRUE(area(result, c) >= 1.0 || result.report.kept_small > 0);
    expect_tiling(result);
  }
}

TEST(CutOutline, FaultsHaveAKindAPlaceAndAHint) {
  EXPECT_EQ(cut_fault(request("0 0 10 10 0 10 10 0", {}), CutError::Kind::outline),
            "the outline is not simple: sides 1 and 3 cross");
  EXPECT_EQ(cut_fault(request("0 0 10 0 10 10 0 10", {}), CutError::Kind::outline),
            "the outline is anticlockwise");
  EXPECT_EQ(cut_fault(request("0 0 10 0", {}), CutError::Kind::outline).substr(0, 26),
            "the outline is not simple:");
  CutRequest cuts = request(ten, {});
  cuts.emin = 10.0;
  EXPECT_EQ(cut_fault(cuts, CutError::Kind::cleaning),
            "emin is not between 0 and the size of the domain");
  cuts.emin = 0.0;
  cuts.amin = 100.0;
  EXPECT_EQ(cut_fault(cuts, CutError::Kind::cleaning),
            "amin is not between 0 and the area of the domain");
  cuts.amin = 0.0;
  cuts.joints = {{Vec2(0.0, NAN), Vec2(1.0, 1.0), 0}};
  EXPECT_EQ(cut_fault(cuts, CutError::Kind::joint),
            "a joint has an end that is not finite");
}

// Doubles about 1e9 are 1.2e-7 apart, and the domain has the size 1e-5.
TEST(CutOutline, CellsThatRoundingDestroysAreRefusedOrCleaned) {
  std::string text;
  std::mt19937_64 random(4);
  for (int i = 0; i < 400; ++i)
    text += "1000000000.00000" + std::to_string(10000 + random() % 90000) + " ";
  CutRequest cuts =
      request("1000000000.000002 1000000000.000002 1000000000.000002 1000000000.000008 "
              "1000000000.000008 1000000000.000008 1000000000.000008 1000000000.000002",
              joints(text));
  EXPECT_EQ(cut_fault(cuts, CutError::Kind::certificate).substr(0, 41),
            "cells are thinner than doubles can repres");
  cuts.emin = 1e-6;
  cuts.amin = 1e-12;
  expect_tiling(cut_outline(cuts));
}

}  // namespace
}  // namespace blocks::geometry
