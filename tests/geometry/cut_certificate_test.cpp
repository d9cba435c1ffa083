// The certificate of a cut domain: the outline of the mesh is that of the request.
#include "geometry/cut_certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::joints;
using testing::request;
using testing::ten;

int vertex_at(const Mesh& mesh, double x, double y) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if ((mesh.vertices[v] - Vec2(x, y)).norm() < 1e-6)
      return static_cast<int>(v);
  return -1;
}

std::string deviation(const CutResult& result, const CutRequest& cuts) {
  const auto fault = outline_deviation(result.mesh, cuts);
  return fault ? fault->fault : "";
}

// Moves one vertex of the mesh; returns the deviation.
std::string deviation_after_move(CutResult result, const CutRequest& cuts,
                                 const Vec2& from, const Vec2& move) {
  const int v = vertex_at(result.mesh, from.x(), from.y());
  EXPECT_GE(v, 0);
  result.mesh.vertices[static_cast<std::size_t>(v)] += move;
  EXPECT_TRUE(certify_tiling(result.mesh).holds);
  return deviation(result, cuts);
}

TEST(CutCertificate, PointsOfAnAxisParallelSideHaveItsCoordinate) {
  const CutRequest cuts = request(ten, joints("0 3 10 4"));
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(deviation(result, cuts), "");
  EXPECT_EQ(deviation_after_move(result, cuts, {0, 3}, {0.0, 1.0}), "");
  EXPECT_EQ(deviation_after_move(result, cuts, {0, 3}, {1e-300, 0.0}),
            "a point of the outline is not on side 1");
  EXPECT_EQ(deviation_after_move(result, cuts, {10, 4}, {0x1p-49, 0.0}),
            "a point of the outline is not on side 3");
}

TEST(CutCertificate, PointsOfASlantedSideAreJustInside) {
  const CutRequest cuts = request("0 0 1 9 10 10 9 1", joints("0 3 10 4"));
  const CutResult result = cut_outline(cuts);
  EXPECT_EQ(deviation(result, cuts), "");
  const double x =
      3.0 / (9.0 - 0.1);  // of the joint y = 3 + x / 10 and the side y = 9 x
  EXPECT_EQ(deviation_after_move(result, cuts, {x, 9.0 * x}, {20 * 0x1p-49, 0.0}), "");
  EXPECT_EQ(deviation_after_move(result, cuts, {x, 9.0 * x}, {80 * 0x1p-49, 0.0}),
            "a point of the outline is not on side 1");
  EXPECT_EQ(deviation_after_move(result, cuts, {x, 9.0 * x}, {-10 * 0x1p-49, 0.0}),
            "a point of the outline is not on side 1");
}

TEST(CutCertificate, EveryCornerRemains) {
  const CutRequest cuts = request(ten, joints("0 3 10 4"));
  CutResult moved = cut_outline(cuts);
  EXPECT_NE(deviation_after_move(moved, cuts, {0, 10}, {0.0, 0x1p-40}), "");
  EXPECT_EQ(deviation_after_move(moved, cuts, {0, 0}, {0.0, 0x1p-40}),
            "corner 1 of the outline is missing");
  CutResult turned = cut_outline(cuts);  // begins at another corner
  std::vector<int>& outline = turned.mesh.outline;
  std::rotate(outline.begin(), outline.begin() + 1, outline.end());
  EXPECT_EQ(deviation(turned, cuts), "corner 1 of the outline is missing");
  CutResult cut_off = cut_outline(cuts);
  Mesh& mesh = cut_off.mesh;
  for (auto* loop : {&mesh.outline, &mesh.cells[0], &mesh.cells[1]})
    loop->erase(std::remove(loop->begin(), loop->end(), vertex_at(mesh, 10, 0)),
                loop->end());
  EXPECT_TRUE(certify_tiling(mesh).holds);
  EXPECT_EQ(deviation(cut_off, cuts), "corner 4 of the outline is missing");
}

TEST(CutCertificate, PointsAreInOrderAlongTheirSide) {
  const CutRequest cuts = request(ten, joints("0 3 10 4 0 6 10 7"));
  CutResult result = cut_outline(cuts);
  Mesh& mesh = result.mesh;
  std::swap(mesh.vertices[static_cast<std::size_t>(vertex_at(mesh, 0, 3))],
            mesh.vertices[static_cast<std::size_t>(vertex_at(mesh, 0, 6))]);
  EXPECT_EQ(deviation(result, cuts), "a point of the outline is not on side 1");
}

// The side becomes slanted by one unit, because the request gives the corner so.
TEST(CutCertificate, GivenCornersMayMakeAnAxisParallelSideSlanted) {
  CutRequest cuts = request(ten, joints("1 0 2 10 3 0 4 10 7 0 7 10"));
  for (const double unit : {0x1p-49, -0x1p-49}) {
    cuts.rounded = {Vec2(0, 0), Vec2(0, 10), Vec2(10, 10 + unit), Vec2(10, 0)};
    EXPECT_EQ(deviation(cut_outline(cuts), cuts), "");
  }
}

// A fault names the joints, and its place is where the sides meet.
TEST(CutCertificate, AFaultHasAPlaceAndNamesTheJoints) {
  CutRequest cuts = request(ten, joints("0 5 10 5.5", 4));
  for (auto& joint : joints("5 0 5.5 10", 7))
    cuts.joints.push_back(joint);
  CutResult result = cut_outline(cuts);
  const auto fault_with = [&](const Vec2& place) {
    CutResult damaged = result;
    const int v = vertex_at(damaged.mesh, 5.25 / 0.9975, 5.25 / 0.9975);
    EXPECT_GE(v, 0);
    damaged.mesh.vertices[static_cast<std::size_t>(v)] = place;
    damaged.certificate = certify_tiling(damaged.mesh);
    StepProgress unseen(cuts.progress, "");
    return find_fault(damaged, cuts, unseen);
  };
  EXPECT_FALSE(fault_with({5.2, 5.2}));
  const auto fault = fault_with({5.25, -1.0});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->fault, "a cell between joint 4 and the outline is thinner than "
                          "doubles can represent");
  EXPECT_NEAR(fault->place.y(), 0.0, 1e-12);
  EXPECT_NEAR(fault->place.x(), 5.0, 1.0);
}

}  // namespace
}  // namespace blocks::geometry
