// What is known exactly of a cut domain in every realisation: Euler's formula for lines
// and for Voronoi cells, and a square with one trace.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "geometry/cut.hpp"
#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::Exact;
using testing::expect_tiling;
using testing::joints;
using testing::points;
using testing::request;
using testing::ten;
using testing::twice_area;

Exact cross_product(const Exact& ax, const Exact& ay, const Exact& bx,
                    const Exact& by) {
  return ax * by - ay * bx;
}

/// The lines that pass through a convex clockwise outline, and their crossings inside,
/// by rationals.
struct Counts {
  std::size_t lines = 0, crossings = 0;

  Counts(const std::vector<JointSegment>& all, const Polygon& outline) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      lines += passes(all[i], outline) ? 1 : 0;
      for (std::size_t j = 0; j < i; ++j)
        crossings += cross_inside(all[i], all[j], outline) ? 1 : 0;
    }
  }

 private:
  // The parts of a line in exact numbers: a point and a direction.
  struct Line {
    Exact x, y, dx, dy;
    explicit Line(const JointSegment& joint)
        : x(joint.from.nearest().x()), y(joint.from.nearest().y()),
          dx(Exact(joint.to.nearest().x()) - x), dy(Exact(joint.to.nearest().y()) - y) {
    }
  };
  static bool passes(const JointSegment& joint, const Polygon& outline) {
    const Line line(joint);
    bool left = false, right = false;
    for (const Vec2& p : outline)
      (cross_product(line.dx, line.dy, Exact(p.x()) - line.x, Exact(p.y()) - line.y) > 0
           ? left
           : right) = true;
    return left && right;
  }
  static bool cross_inside(const JointSegment& one, const JointSegment& two,
                           const Polygon& outline) {
    const Line a(one), b(two);
    const Exact s = cross_product(b.x - a.x, b.y - a.y, b.dx, b.dy) /
                    cross_product(a.dx, a.dy, b.dx, b.dy);
    const Exact x = a.x + s * a.dx, y = a.y + s * a.dy;
    bool inside = true;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
      inside = inside &&
               cross_product(Exact(q.x()) - Exact(p.x()), Exact(q.y()) - Exact(p.y()),
                             x - Exact(p.x()), y - Exact(p.y())) < 0;
    }
    return inside;
  }
};

// Random lines about the square of side 10; they are longer than its diagonal.
std::vector<JointSegment> random_lines(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<JointSegment> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * part(random);
    const Vec2 p(10.0 * part(random), 10.0 * part(random));
    const Vec2 d(40.0 * std::cos(angle), 40.0 * std::sin(angle));
    result.push_back({Vec2(p - d), Vec2(p + d), static_cast<int>(i % 4)});
  }
  return result;
}

// Each line adds a face, and so does each crossing. Each line has two nodes on the
// outline, and each crossing divides two lines.
TEST(CutIdentities, LinesInGeneralPositionMakeOneFacePerLineAndCrossing) {
  std::size_t missed = 0;
  for (const std::string& outline :
       {ten, std::string("0 3 2 10 9 9 10 4 6 0"), std::string("0 0 0.1 10 9.9 0.3")})
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(outline + ", seed " + std::to_string(seed));
      const CutRequest cuts = request(outline, random_lines(seed % 20, seed));
      Polygon corners;
      for (const DecimalPoint& p : cuts.outline)
        corners.emplace_back(p.x.value(), p.y.value());
      const Counts known(cuts.joints, corners);
      missed += cuts.joints.size() - known.lines;
      const CutResult result = cut_outline(cuts);
      const CutReport& report = result.report;
      EXPECT_EQ(result.mesh.cells.size(), 1 + known.lines + known.crossings);
      const long lines = static_cast<long>(known.lines),
                 crossings = static_cast<long>(known.crossings);
      EXPECT_EQ(report.faces, 1 + lines + crossings);
      EXPECT_EQ(report.vertices, std::ssize(corners) + 2 * lines + crossings);
      EXPECT_EQ(report.edges, std::ssize(corners) + 3 * lines + 2 * crossings);
      EXPECT_EQ(report.components, 1);
      EXPECT_EQ(report.pruned_edges, 0);
      EXPECT_EQ(report.x_vertices, crossings);
      EXPECT_EQ(report.t_vertices, 0);
      if (seed < 12)
        expect_tiling(result);
    }
  EXPECT_GT(missed, 0U);  // some lines miss the smaller outlines
}

// Cells of points in general position meet in threes.
TEST(CutIdentities, VoronoiCellsHaveTheNumberOfVerticesOfEulersFormula) {
  for (const std::string& outline : {ten, std::string("0 3 2 10 9 9 10 4 6 0"),
                                     std::string("0 0 0 10 5 4 10 10 10 0")})
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(outline + ", seed " + std::to_string(seed));
      VoronoiRequest cells;
      cells.count = 1 + static_cast<int>(seed * seed % 60);
      cells.lloyd = static_cast<int>(seed % 3);
      cells.stream = {seed, 7};
      cells.id = 3;
      CutRequest all = request(outline, {});
      all.joints = voronoi_cells(cells, all.outline).edges;
      const CutResult result = cut_outline(all);
      const std::size_t faces = result.mesh.cells.size();
      const std::size_t nodes = result.mesh.outline.size() - all.outline.size();
      const std::size_t inner =
          result.mesh.vertices.size() - result.mesh.outline.size();
      EXPECT_EQ(inner + nodes, 2 * (faces - 1));
      EXPECT_EQ(result.report.x_vertices, 0);
      // A concave outline may divide cells.
      if (all.outline.size() == 5 && outline[2] == '0')
        EXPECT_GE(faces, static_cast<std::size_t>(cells.count));
      else
        EXPECT_EQ(faces, static_cast<std::size_t>(cells.count));
      if (seed < 8)
        expect_tiling(result);
    }
}

// The trace of each test, turned by quarters about the middle of the square.
const std::vector<std::string> turned_free = {"0 5 9 5", "5 10 5 1", "10 5 1 5",
                                              "5 0 5 9"};

TEST(CutIdentities, TraceWithOneFreeEndIsPruned) {
  for (const std::string& trace : turned_free) {
    SCOPED_TRACE(trace);
    const CutResult result = cut_outline(request(ten, joints(trace, 4)));
    EXPECT_EQ(result.mesh.cells.size(), 1U);
    EXPECT_EQ(result.report.faces, 1);
    EXPECT_EQ(result.report.lengths.at(4).drawn, 9.0);
    EXPECT_EQ(result.report.lengths.at(4).pruned, 9.0);
    EXPECT_EQ(result.report.p21_before, 0.09);
    EXPECT_EQ(result.report.p21_after, 0.0);
    // The vertex where the trace met the outline is gone as well.
    EXPECT_EQ(result.mesh.vertices.size(), 4U);
  }
}

TEST(CutIdentities, ProlongedTraceHalvesTheSquare) {
  for (const std::string& trace : turned_free) {
    SCOPED_TRACE(trace);
    CutRequest square = request(ten, joints(trace, 4));
    const Prolongation traces =
        prolonged(square.joints, Decimal(1), {}, square.outline);
    EXPECT_EQ(traces.ends, 1U);
    EXPECT_EQ(traces.largest, 1.0);
    square.joints = traces.traces;
    const CutResult result = cut_outline(square);
    ASSERT_EQ(result.mesh.cells.size(), 2U);
    for (const auto& cell : result.mesh.cells)
      EXPECT_EQ(twice_area(testing::polygon(result.mesh, cell)), 100);
    EXPECT_EQ(result.report.pruned_edges, 0);
    EXPECT_EQ(result.report.lengths.at(4).drawn, 10.0);
  }
}

// The gap is 1 exactly, so a smaller snap does not reach the outline.
TEST(CutIdentities, SnapBelowTheGapProlongsNothing) {
  const Decimal snap = testing::number("0.99999999999999999999");
  EXPECT_EQ(snap.value(), 1.0);
  const auto traces = joints("0 5 9 5", 4);
  const Prolongation result = prolonged(traces, snap, {}, points(ten));
  EXPECT_EQ(result.ends, 0U);
  EXPECT_EQ(result.traces[0].to.nearest(), Vec2(9, 5));
}

// The decimals 0.3 and 9.7 are not doubles. The trace still bisects the square, and its
// ends are the nearest doubles.
TEST(CutIdentities, SlantedTraceBisectsTheSquareAndMovesNothing) {
  const Exact near(0.3), far(9.7);
  for (const std::string& trace :
       {std::string("0.3 0 9.7 10"), std::string("0 9.7 10 0.3"),
        std::string("9.7 10 0.3 0"), std::string("9.7 0 0.3 10")}) {
    SCOPED_TRACE(trace);
    const CutRequest square = request(ten, joints(trace));
    const CutResult result = cut_outline(square);
    ASSERT_EQ(result.mesh.cells.size(), 2U);
    EXPECT_EQ(result.mesh.vertices.size(), 6U);
    for (const ExactPoint* end : {&square.joints[0].from, &square.joints[0].to})
      EXPECT_EQ(std::count(result.mesh.vertices.begin(), result.mesh.vertices.end(),
                           end->nearest()),
                1);
    // In decimals both areas are 50. In doubles the lower or left part is 5 (0.3
    // + 9.7).
    std::vector<Exact> areas;
    for (const auto& cell : result.mesh.cells) {
      areas.push_back(twice_area(testing::polygon(result.mesh, cell)));
      EXPECT_LT(abs(areas.back() - 100), Exact(1e-14));
    }
    EXPECT_EQ(areas[0] + areas[1], 200);
    EXPECT_EQ(std::count(areas.begin(), areas.end(), 10 * (near + far)), 1);
    EXPECT_EQ(result.report.moved_t_vertices + result.report.contractions +
                  result.report.merges,
              0U);
    EXPECT_EQ(result.report.largest_move, 0.0);
  }
}

}  // namespace
}  // namespace blocks::geometry
