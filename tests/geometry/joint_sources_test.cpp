// Joint sets and Voronoi cells: conventions and exactness.
#include "geometry/joint_sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/exact/numbers.hpp"
#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::joints;
using testing::number;
using testing::points;
using testing::request;
using testing::ten;
using testing::twice_area;

JointSet set_of(const std::string& dip, const std::string& spacing,
                const std::string& trace = "0", const std::string& gap = "0") {
  JointSet set;
  set.id = 2;
  set.dip.mean = number(dip);
  set.spacing.mean = number(spacing);
  set.trace.mean = number(trace);
  set.gap.mean = number(gap);
  set.stream = {1, 2};
  return set;
}

std::string square(double size) {
  const std::string s = std::to_string(size);
  return "0 0 0 " + s + " " + s + " " + s + " " + s + " 0";
}

double length(const JointSegment& joint) {
  return (joint.to.nearest() - joint.from.nearest()).norm();
}

TEST(DirectionOfDegrees, IsCorrectlyRoundedAndExactAtRightAngles) {
  const auto direction = [](int degrees) {
    return exact::direction_of_degrees(exact::Rational(degrees));
  };
  EXPECT_EQ(direction(0), Vec2(1, 0));
  EXPECT_EQ(direction(90), Vec2(0, 1));
  EXPECT_EQ(direction(180), Vec2(-1, 0));
  EXPECT_EQ(direction(-90), Vec2(0, -1));
  EXPECT_EQ(direction(30).y(), 0.5);
  EXPECT_EQ(direction(-60).x(), 0.5);
  EXPECT_EQ(direction(120).x(), -0.5);
  EXPECT_EQ(direction(45).x(), direction(45).y());
  EXPECT_EQ(direction(45).x(), std::numbers::sqrt2 / 2.0);
  for (int degrees = -400; degrees < 400; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    EXPECT_NEAR(direction(degrees).x(), std::cos(angle), 2e-15);
    EXPECT_NEAR(direction(degrees).y(), std::sin(angle), 2e-15);
    EXPECT_EQ(direction(degrees), direction(degrees + 360));
  }
}

// Tracks at multiples of the decimal 0.1 meet the decimal corners of the outline.
TEST(JointSets, EvenSpacingIsExact) {
  const auto outline = points("0 0 0 0.3 0.1 0.3 0.1 0.6 1 0.6 1 0");
  CutRequest cuts;
  cuts.outline = outline;
  cuts.joints = joint_set(set_of("0", "0.1"), outline);
  const CutResult result = cut_outline(cuts);
  // Five tracks inside; the one at 0.3 starts at the re-entrant corner.
  EXPECT_EQ(result.mesh.cells.size(), 6U);
  for (const CutBlock& block : result.blocks)
    EXPECT_GE(block.corners.size(), 4U);
}

TEST(JointSets, TrackZeroBeginsAtTheStart) {
  JointSet set = set_of("0", "100", "2", "1");
  set.start = points("3 5")[0];
  const auto traces = joint_set(set, points(ten));
  std::vector<double> begins;
  for (const JointSegment& trace : traces) {
    if (trace.from.nearest().y() != 5.0)  // a track outside of the window
      continue;
    EXPECT_EQ(trace.id, 2);
    begins.push_back(trace.from.nearest().x());
  }
  for (const double x : {0.0, 3.0, 6.0, 9.0})
    EXPECT_EQ(std::count(begins.begin(), begins.end(), x), 1) << x;
}

TEST(JointSets, DipIsAnticlockwiseFromTheXAxis) {
  JointSet set = set_of("30", "1");
  for (const JointSegment& line : joint_set(set, points(ten))) {
    const Vec2 d = line.to.nearest() - line.from.nearest();
    EXPECT_NEAR(std::atan2(d.y(), d.x()), std::numbers::pi / 6.0, 1e-12);
  }
  set = set_of("30", "1", "2", "1");
  set.dip.deviation = number("5");
  double min = 90.0, max = 0.0;
  for (const JointSegment& trace : joint_set(set, points(square(40.0)))) {
    const Vec2 d = trace.to.nearest() - trace.from.nearest();
    EXPECT_NEAR(length(trace), 2.0, 1e-12);
    const double dip = std::atan2(d.y(), d.x()) * 180.0 / std::numbers::pi;
    min = std::min(min, dip);
    max = std::max(max, dip);
  }
  EXPECT_NEAR(min, 25.0, 0.2);
  EXPECT_NEAR(max, 35.0, 0.2);
}

TEST(JointSets, AnotherOutlineOrStreamDoesNotChangeThePieces) {
  for (const SpacingLaw law :
       {SpacingLaw::uniform, SpacingLaw::negexp, SpacingLaw::poisson}) {
    JointSet set = set_of("20", "1", "3", "1");
    set.law = law;
    set.spacing.deviation = number("0.5");
    set.trace.deviation = number("1");
    const auto small = joint_set(set, points(ten));
    const auto large = joint_set(set, points("-20 -20 -20 30 30 30 30 -20"));
    // Each trace inside the small square is one of the large square.
    std::size_t inside = 0;
    for (const JointSegment& trace : small) {
      const Vec2 a = trace.from.nearest(), b = trace.to.nearest();
      if (a.minCoeff() < 0.0 || b.minCoeff() < 0.0 || a.maxCoeff() > 10.0 ||
          b.maxCoeff() > 10.0)
        continue;
      ++inside;
      EXPECT_TRUE(std::any_of(large.begin(), large.end(), [&](const auto& other) {
        return other.from.nearest() == a && other.to.nearest() == b;
      }));
    }
    EXPECT_GT(inside, 5U);
    JointSet other = set;
    other.stream.layer = 3;
    EXPECT_NE(joint_set(other, points(ten)).back().from.nearest(),
              small.back().from.nearest());
  }
}

TEST(JointSets, FaultsAreReportedBeforeAnythingIsComputed) {
  const auto fault = [](const JointSet& set) -> std::string {
    try {
      joint_set(set, points(ten));
    } catch (const CutError& error) {
      EXPECT_EQ(error.kind, CutError::Kind::generator);
      return error.what();
    }
    return "no fault";
  };
  EXPECT_EQ(fault(set_of("0", "0")), "the mean spacing is not positive");
  EXPECT_EQ(fault(set_of("0", "1e-8")),
            "the joint set has too many pieces for its spacing");
  EXPECT_EQ(fault(set_of("0", "1e-3", "1e-6", "0")),
            "the joint set has too many pieces for its spacing");
  JointSet set = set_of("0", "1");
  set.spacing.deviation = number("1");
  EXPECT_EQ(fault(set), "the spacing may be 0 or negative");
  set = set_of("0", "1", "1");
  set.trace.deviation = number("2");
  EXPECT_EQ(fault(set), "traces may have length 0");
}

// The limit of the number of pieces must not refuse a long and narrow outline.
TEST(JointSets, ExpectedPiecesOfANarrowOutlineAreCloseToTheirNumber) {
  for (const std::string& outline : {std::string("0 0 0 40 2 40 2 0"), ten}) {
    const JointSet set = set_of("0", "0.5", "3", "2");
    const double expected = expected_pieces(set, points(outline));
    const auto pieces = static_cast<double>(joint_set(set, points(outline)).size());
    EXPECT_GT(expected, pieces) << outline;
    EXPECT_LT(expected, 2.0 * pieces) << outline;
  }
}

// The part with the middle remains; a joint that only touches the line of the trace
// beyond its end, or runs along it, does not end it.
TEST(EndedAt, KeepsThePartAroundTheMiddle) {
  const auto traces = joints("2 0 2 10 4 0 4 3 6 2 6 8");
  const auto beds = joints("0 1 10 1 0 4 10 4 0 9 10 9 4 0 4 10 6 5 9 5", 7);
  const auto ended = ended_at(traces, beds);
  EXPECT_EQ(ended[0].from.nearest(), Vec2(2, 4));
  EXPECT_EQ(ended[0].to.nearest(), Vec2(2, 9));
  EXPECT_EQ(ended[1].from.nearest(), Vec2(4, 1));
  EXPECT_EQ(ended[1].to.nearest(), Vec2(4, 3));
  EXPECT_EQ(ended[2].from.nearest(), Vec2(6, 5));  // through the middle
  EXPECT_EQ(ended[2].to.nearest(), Vec2(6, 8));
  EXPECT_EQ(ended[0].id, traces[0].id);
}

// The ends are on the beds exactly, whatever the directions: each cross joint between
// two beds separates two cells, and none is pruned.
TEST(EndedAt, IsExact) {
  JointSet beds = set_of("17.3", "1.7");
  beds.id = 7;
  JointSet cross = set_of("103.9", "1.1", "6");
  cross.dip.deviation = number("8");
  cross.whole = true;
  const auto layers = joint_set(beds, points(ten));
  auto network = ended_at(joint_set(cross, points(ten)), layers);
  EXPECT_GT(network.size(), 40U);
  network.insert(network.end(), layers.begin(), layers.end());
  const CutResult result = cut_outline(request(ten, network));
  testing::expect_tiling(result);
  // Only what leaves the outline between two beds could be pruned, and that ends at it.
  EXPECT_LT(result.report.lengths.at(2).pruned, 1e-12);
  EXPECT_GT(result.report.lengths.at(2).drawn, 20.0);
  EXPECT_EQ(result.report.x_vertices, 0);  // no cross joint crosses a bed
}

TEST(Voronoi, PointsMayBeVeryCloseOrNearlyOnALine) {
  for (const std::vector<Vec2>& given :
       {std::vector<Vec2>{{1e-300, 0}, {2e-300, 0}, {5, 5}},
        std::vector<Vec2>{{0, 5}, {5, 5}, {5, 5e-320}, {10, 0}, {0, 0}},
        std::vector<Vec2>{{5e-324, 0}, {0, 0}},
        std::vector<Vec2>{{2, 0}, {5, 1e-320}, {8, 0}}}) {
    VoronoiRequest cells;
    cells.points = given;
    const CutResult result =
        cut_outline(request(ten, voronoi_cells(cells, points(ten)).edges));
    EXPECT_GE(result.mesh.cells.size(), given.size() - 1);
    testing::expect_tiling(result);
  }
  VoronoiRequest far;
  far.points = {{1e300, 1e300}, {5, 5}};
  EXPECT_THROW(voronoi_cells(far, points(ten)), CutError);
}

TEST(Voronoi, PointsOnALineAndOnACircleAreCut) {
  VoronoiRequest cells;
  cells.points = {{1, 1}, {3, 3}, {8, 8}};
  CutRequest cuts = request(ten, voronoi_cells(cells, points(ten)).edges);
  EXPECT_EQ(cut_outline(cuts).mesh.cells.size(), 3U);
  cells.points.clear();
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      cells.points.emplace_back(1 + 2 * i, 1 + 2 * j);
  cuts.joints = voronoi_cells(cells, points(ten)).edges;
  const CutResult lattice = cut_outline(cuts);
  EXPECT_EQ(lattice.mesh.cells.size(), 25U);
  EXPECT_EQ(lattice.report.x_vertices, 16);
  cells.points = {{5, 5}};
  EXPECT_TRUE(voronoi_cells(cells, points(ten)).edges.empty());
}

TEST(Voronoi, RepeatedPointsCountOnceInEveryRound) {
  const auto outline = points("0 0 0 10 10 10 10 0");
  for (const int rounds : {0, 1, 2}) {
    VoronoiRequest once{1, 0, {{3, 3}, {7, 7}, {2, 8}}, rounds, {}},
        twice{1, 0, {{3, 3}, {3, 3}, {7, 7}, {2, 8}, {7, 7}}, rounds, {}};
    EXPECT_EQ(voronoi_cells(once, outline).points,
              voronoi_cells(twice, outline).points);
  }
}

TEST(Voronoi, RelaxationEvensTheAreas) {
  VoronoiRequest cells;
  cells.count = 200;
  cells.stream = {5, 1};
  double before = 0.0;
  for (const int rounds : {0, 2, 10}) {
    cells.lloyd = rounds;
    const CutResult result =
        cut_outline(request(ten, voronoi_cells(cells, points(ten)).edges));
    EXPECT_EQ(result.mesh.cells.size(), 200U);
    double squares = 0.0;
    for (const auto& cell : result.mesh.cells) {
      const double area =
          static_cast<double>(twice_area(testing::polygon(result.mesh, cell)) / 2);
      squares += (area / 0.5 - 1.0) * (area / 0.5 - 1.0);
    }
    EXPECT_TRUE(rounds == 0 || squares < before);
    before = squares;
  }
}

}  // namespace
}  // namespace blocks::geometry
