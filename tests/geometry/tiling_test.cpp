#include "geometry/tiling.hpp"

#include <gtest/gtest.h>

namespace blocks::geometry {
namespace {

/// Returns a wall of n by n unit squares on shared vertices.
Mesh wall(int n) {
  Mesh mesh;
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.vertices.emplace_back(i, j);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mesh.cells.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
  for (int j = 0; j < n; ++j)
    mesh.outline.push_back(at(0, j));
  for (int i = 0; i < n; ++i)
    mesh.outline.push_back(at(i, n));
  for (int j = n; j > 0; --j)
    mesh.outline.push_back(at(n, j));
  for (int i = n; i > 0; --i)
    mesh.outline.push_back(at(i, 0));
  return mesh;
}

TEST(TilingCertificate, HoldsForAWallAndCountsItsEdges) {
  const TilingCertificate c = certify_tiling(wall(3));
  EXPECT_TRUE(c.holds) << c.fault;
  EXPECT_EQ(c.cells, 9);
  EXPECT_EQ(c.interior_edges, 12);
  EXPECT_EQ(c.outline_edges, 12);
}

TEST(TilingCertificate, FailsForAVertexMovedAcrossItsCell) {
  Mesh mesh = wall(3);
  mesh.vertices[5] = {
      2.5, 2.5};  // The areas still add up, because the cells share the vertex.
  const TilingCertificate c = certify_tiling(mesh);
  EXPECT_FALSE(c.holds);
  EXPECT_FALSE(c.offending_cells.empty());
}

TEST(TilingCertificate, FailsForADuplicatedCell) {
  Mesh mesh = wall(2);
  mesh.cells.push_back(mesh.cells[3]);
  const TilingCertificate c = certify_tiling(mesh);
  EXPECT_FALSE(c.holds);
  EXPECT_EQ(c.offending_cells.size(), 2U);
}

TEST(TilingCertificate, FailsForAMissingCell) {
  for (const int missing : {4, 0}) {
    Mesh mesh = wall(3);
    mesh.cells.erase(mesh.cells.begin() + missing);
    EXPECT_FALSE(certify_tiling(mesh).holds) << missing;
  }
}

TEST(TilingCertificate, FailsForAnAnticlockwiseCell) {
  Mesh turned = wall(1);
  std::swap(turned.cells[0][1], turned.cells[0][3]);
  EXPECT_FALSE(certify_tiling(turned).holds);
}

TEST(TilingCertificate, FailsForAVertexIndexOutOfRange) {
  Mesh bad = wall(1);
  bad.cells[0][2] = 99;
  EXPECT_FALSE(certify_tiling(bad).holds);
}

TEST(TilingCertificate, FailsForAnEmptyMesh) {
  EXPECT_FALSE(certify_tiling(Mesh{}).holds);
}

TEST(TilingCertificate, FailsForAnOutlineThatCrossesItself) {
  // Every inner edge belongs to two cells and every cell is a clockwise triangle, but
  // the fan of triangles goes around its centre twice.
  Mesh mesh;
  mesh.vertices.emplace_back(0, 0);
  const int n = 5;
  const double x[n] = {0, 2, -3, 3, -2};
  const double y[n] = {3, -3, 1, 1, -3};
  for (int i = 0; i < n; ++i)
    mesh.vertices.emplace_back(x[i], y[i]);
  for (int i = 0; i < n; ++i) {
    mesh.cells.push_back({0, 1 + i, 1 + (i + 1) % n});
    mesh.outline.push_back(1 + i);
  }
  const TilingCertificate c = certify_tiling(mesh);
  EXPECT_EQ(c.cells, n);
  EXPECT_FALSE(c.holds);
}

}  // namespace
}  // namespace blocks::geometry
