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

TEST(CutOutline, WithoutJointsIsOneBlock) {
  const CutResult result = cut_outline(request(ten, {}));
  EXPECT_EQ(result.mesh.cells.size(), 1U);
  EXPECT_EQ(result.blocks[0].corners.size(), 4U);
  EXPECT_EQ(result.report.faces, 1);
  EXPECT_EQ(result.report.components, 1);
}

TEST(CutOutline, IslandsAndLoopsAtOneVertexAreAbsorbed) {
  // A closed triangle inside, a triangle that hangs from the outline at (0, 5), and a
  // triangle on a bridge.
  const CutResult result =
      cut_outline(request(ten, joints("4 4 6 4 6 4 5 6 5 6 4 4 "
                                      "0 5 2 6 2 6 2 4 2 4 0 5 "
                                      "10 5 9 5 9 5 8 6 8 6 8 4 8 4 9 5")));
  EXPECT_EQ(result.mesh.cells.size(), 1U);
  EXPECT_EQ(result.report.faces, 4);
  EXPECT_EQ(result.report.components, 2);
  EXPECT_EQ(result.report.islands, 1);
  EXPECT_EQ(result.report.pinched_loops, 2);
  EXPECT_EQ(result.report.absorbed_faces, 3);
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
  EXPECT_EQ(result.report.t_vertices, 1);
  EXPECT_EQ(result.report.kept_t_vertices, 0);
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
  EXPECT_EQ(result.report.kept_short, 0);
  EXPECT_GE(result.report.contractions, 2);
  EXPECT_GT(result.report.largest_move, 0.0);
  EXPECT_LT(result.report.largest_move, 0.01);
  expect_tiling(result);
}

// A perimeter with id 9 in a network that cleaning changes: all its vertices keep their
// places, and its cells keep its sides.
TEST(CutOutline, ProtectedJointsStayWhereTheyAre) {
  const auto perimeter = joints("3 3 3 7 3 7 7 7 7 7 7 3 7 3 3 3", 9);
  std::size_t moved = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    CutRequest cuts = request(ten, random_joints(60, 2.5, seed));
    cuts.joints.insert(cuts.joints.end(), perimeter.begin(), perimeter.end());
    const auto length_off = [&](const CutResult& result) {
      double sum = 0.0;  // of the edges that are on the perimeter
      for (const CutBlock& block : result.blocks)
        for (std::size_t i = 0; i < block.corners.size(); ++i) {
          const auto place = [&](std::size_t k) {
            return result.mesh.vertices[static_cast<std::size_t>(
                block.corners[k % block.corners.size()])];
          };
          const Vec2 a = place(i), b = place(i + 1);
          for (const int axis : {0, 1})
            if (a[axis] == b[axis] && (a[axis] == 3.0 || a[axis] == 7.0) &&
                std::min(a[1 - axis], b[1 - axis]) >= 3.0 &&
                std::max(a[1 - axis], b[1 - axis]) <= 7.0)
              sum += (a - b).norm();
        }
      return sum;
    };
    const double whole = length_off(cut_outline(cuts));
    EXPECT_NEAR(whole, 32.0, 1e-12);
    cuts.emin = 0.5;
    cuts.amin = 0.5;
    moved += length_off(cut_outline(cuts)) < 31.9 ? 1U : 0U;
    cuts.protected_joints = {9};
    const CutResult result = cut_outline(cuts);
    EXPECT_NEAR(length_off(result), whole, 1e-12) << seed;
    EXPECT_GT(result.report.contractions, 0);
    EXPECT_EQ(result.report.repaired_below, 0.0);
    expect_tiling(result);
  }
  EXPECT_GT(moved, 2U);  // without protection
}

// What protection keeps short is counted as other edges that remain short are.
TEST(CutOutline, ShortEdgesOfProtectedJointsAreCounted) {
  CutRequest cuts = request(ten, joints("0 5 10 5 5 0 5 10 0.001 0 10 9.999"));
  cuts.emin = 0.01;
  cuts.protected_joints = {1};
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(result.mesh.cells.size(), 7U);
  EXPECT_GT(result.report.kept_short, 0);
  EXPECT_EQ(result.report.contractions, 0);
  expect_tiling(result);
}

// A joint across a narrow domain cannot be contracted, but the merge removes it.
TEST(CutOutline, ShortEdgesAreCountedAfterAllCleaning) {
  CutRequest cuts = request("0 0 0 0.05 10 0.05 10 0", joints("5 0 5 0.05"));
  cuts.emin = 0.06;
  EXPECT_EQ(cut_outline(cuts).report.kept_short, 3);
  cuts.amin = 0.3;
  EXPECT_EQ(cut_outline(cuts).report.kept_short, 2);
  for (unsigned seed = 0; seed < 20; ++seed) {
    cuts = request("0 0 0 10 0.1 10 10 10 10 0", random_joints(60, 2.5, seed));
    cuts.emin = 0.8;
    cuts.amin = 1.0;
    const CutResult result = cut_outline(cuts);
    std::set<std::pair<int, int>> sides;
    for (const CutBlock& block : result.blocks)
      for (std::size_t i = 0; i < block.corners.size(); ++i) {
        const int v = block.corners[i];
        const int w = block.corners[(i + 1) % block.corners.size()];
        const auto place = [&](int vertex) {
          return result.mesh.vertices[static_cast<std::size_t>(vertex)];
        };
        if ((place(v) - place(w)).norm() < 0.8)
          sides.insert(std::minmax({v, w}));
      }
    EXPECT_EQ(result.report.kept_short, std::ssize(sides));
  }
}

TEST(CutOutline, SmallCellsAreMergedAlongTheLongestChain) {
  // A strip of width 0.01 beside the left half.
  CutRequest cuts = request(ten, joints("5 0 5 10 5.01 0 5.01 10 5.01 5 10 5", 2));
  EXPECT_EQ(cut_outline(cuts).mesh.cells.size(), 4U);
  cuts.amin = 0.2;
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(result.mesh.cells.size(), 3U);
  EXPECT_EQ(result.report.merges, 1);
  EXPECT_EQ(result.report.kept_small, 0);
  // Vertices of the removed side are gone.
  EXPECT_EQ(result.mesh.vertices.size(), 8U);
  expect_tiling(result);
}

// The joint becomes a part of the outline, and its end on it no corner.
TEST(CutOutline, JointsContractedOntoTheOutlineLeaveNothing) {
  CutRequest cuts = request(ten, joints("0 0.01 5 0"));
  cuts.emin = 0.05;
  const CutResult result = cut_outline(cuts);
  ASSERT_EQ(result.blocks.size(), 1U);
  EXPECT_EQ(result.blocks[0].joints, std::vector<int>(4, 0));
  for (unsigned seed = 0; seed < 20; ++seed) {
    cuts = request(ten, random_joints(60, 2.5, seed));
    cuts.emin = 0.8;
    const CutResult cleaned = cut_outline(cuts);
    std::set<std::pair<int, int>> outline;
    const std::vector<int>& loop = cleaned.mesh.outline;
    for (std::size_t i = 0; i < loop.size(); ++i)
      outline.emplace(loop[i], loop[(i + 1) % loop.size()]);
    for (std::size_t c = 0; c < cleaned.mesh.cells.size(); ++c) {
      const auto& cell = cleaned.mesh.cells[c];
      for (std::size_t i = 0; i < cell.size(); ++i)
        if (outline.contains({cell[i], cell[(i + 1) % cell.size()]})) {
          EXPECT_EQ(cleaned.joints[c][i], 0);
        }
    }
    expect_tiling(cleaned);
  }
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

// The second joint has the nearest doubles of the ends, so the two enclose a cell that
// is thinner than doubles can represent.
TEST(CutOutline, JointsThatCoincideUpToRoundingBecomeOne) {
  for (const double end : {6.1, 6.7, 7.3}) {
    CutRequest cuts = request(ten, joints("0 3.3 10 " + std::to_string(end), 1));
    cuts.joints.push_back({Vec2(0.0, 3.3), Vec2(10.0, end), 2});
    const CutResult result = cut_outline(cuts);
    EXPECT_EQ(result.mesh.cells.size(), 2U);
    expect_tiling(result);
  }
}

// CGAL's sweep alone takes 30 s for 2,000 copies and cubic time beyond.
TEST(CutOutline, ManyCopiesOfAJointAreOneJoint) {
  std::vector<JointSegment> cuts;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 left(0.0, 5.0), right(10.0 - 1e-4 * (i % 2 == 0 ? 0 : i), 5.0);
    cuts.push_back({i % 3 == 0 ? left : right, i % 3 == 0 ? right : left, i % 5});
  }
  const CutResult result = cut_outline(request(ten, cuts));
  ASSERT_EQ(result.mesh.cells.size(), 2U);
  EXPECT_EQ(result.mesh.cells[0].size(), 4U);
  EXPECT_NEAR(result.report.lengths.at(1).drawn, 10.0, 1e-9);
}

TEST(CutOutline, JointsOnTheOutlineAreNoCornersOfIt) {
  const CutResult result = cut_outline(
      request(ten, joints("0 2 0 5 3 10 7 10 10 1 10 12 2 0 4 0 3 0 6 0 0 5 10 5")));
  ASSERT_EQ(result.blocks.size(), 2U);
  for (const CutBlock& block : result.blocks) {
    EXPECT_EQ(block.corners.size(), 4U);
    EXPECT_EQ(std::count(block.joints.begin(), block.joints.end(), 0), 3);
  }
}

// Products of such coordinates are not doubles.
TEST(CutOutline, EndsOfJointsMayBeVeryFarAway) {
  const CutResult result =
      cut_outline(request(ten, joints("-1e300 -1e300 1e300 1e300 0 1e300 10 -1e300 "
                                      "0 3 1e300 3 "
                                      "1e300 5 2e300 1e300")));
  EXPECT_EQ(result.mesh.cells.size(), 7U);
  expect_tiling(result);
  EXPECT_EQ(cut_fault(request("0 0 0 1e300 1e300 1e300 1e300 0", {}),
                      CutError::Kind::outline),
            "a corner is too far away to calculate with");
}

// The second joint crosses the slanted side in (4.5, 1.5) and encloses a triangle with
// it whose other two vertices are rounded to one corner of the outline.
TEST(CutOutline, CellsOfNoAreaVanishAtTheOutline) {
  const CutResult result =
      cut_outline(request("0 0 0 8 9 8 9 3", joints("-3 -1.000000000000000001 12 "
                                                    "4.000000000000000001 3 1 5 8")));
  EXPECT_EQ(result.mesh.cells.size(), 2U);
  EXPECT_EQ(result.report.contractions, 1);
  expect_tiling(result);
}

// Doubles about 1e9 are 1.2e-7 apart, and the domain has the size 1e-5.
TEST(CutOutline, CellsThatRoundingDestroysAreRepaired) {
  std::string text;
  std::mt19937_64 random(4);
  for (int i = 0; i < 400; ++i)
    text += "1000000000.00000" + std::to_string(10000 + random() % 90000) + " ";
  CutRequest cuts =
      request("1000000000.000002 1000000000.000002 1000000000.000002 1000000000.000008 "
              "1000000000.000008 1000000000.000008 1000000000.000008 1000000000.000002",
              joints(text));
  const CutResult repaired = cut_outline(cuts);
  expect_tiling(repaired);
  EXPECT_GT(repaired.report.contractions, 0);
  EXPECT_GT(repaired.report.repaired_below, 0.0);
  cuts.emin = 1e-6;
  cuts.amin = 1e-12;
  expect_tiling(cut_outline(cuts));
}

}  // namespace
}  // namespace blocks::geometry
