// Nodes, branches and pieces of maps whose topology is known.
#include <gtest/gtest.h>

#include "joints/network.hpp"
#include "joints/statistics.hpp"
#include "validation/traces/maps.hpp"

namespace blocks::joints {
namespace {

using testing::generated;
using testing::joint_set;
using testing::map_of;
using testing::rectangle;
using testing::SetNumbers;

const std::string ten = "0 0 0 10 10 10 10 0";

TEST(TraceNetwork, ACrossingAnAbutmentAndLooseEnds) {
  // A horizontal trace, one that crosses it, and one that ends on it exactly.
  const Network n = network_of(map_of(ten, {"1 5 9 5", "3 2 3 8", "6 5 6 9"}));
  EXPECT_EQ(n.nodes.i, 5U);
  EXPECT_EQ(n.nodes.y, 1U);
  EXPECT_EQ(n.nodes.x, 1U);
  EXPECT_EQ(n.nodes.window, 0U);
  EXPECT_EQ(n.branches.size(), 6U);
  const Topology t = topology_of(n);
  EXPECT_EQ(t.branches, 6.0);  // (5 + 3 + 4) / 2
  EXPECT_EQ(t.lines, 3.0);
  EXPECT_EQ(t.cc, 1U);
  EXPECT_EQ(t.ci, 5U);
  EXPECT_DOUBLE_EQ(t.connections_per_branch, 7.0 / 6.0);
  EXPECT_DOUBLE_EQ(t.connections_per_line, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(n.length(), 8.0 + 6.0 + 4.0);
}

// An end that misses a trace by one unit in the last place is no abutment: nothing but
// --snap joins it.
TEST(TraceNetwork, NoToleranceDecides) {
  const std::string close = "6 5.000000000000001 6 9";
  EXPECT_EQ(network_of(map_of(ten, {"1 5 9 5", close})).nodes.y, 0U);
  TraceMap map = map_of(ten, {"1 5 9 5", close});
  EXPECT_EQ(close_gaps(map, testing::decimal(1e-9)), 1U);
  const Network joined = network_of(map);
  EXPECT_EQ(joined.nodes.y, 1U);
  EXPECT_EQ(joined.nodes.i, 3U);
}

TEST(TraceNetwork, AnOvershootIsCutAndALongerEndIsKept) {
  const std::vector<std::string> lines = {"1 5 9 5", "4 4.9 4 9", "6 4 6 9"};
  const Network raw = network_of(map_of(ten, lines));
  EXPECT_EQ(raw.nodes.x, 2U);
  TraceMap map = map_of(ten, lines);
  map.snap = 0.2;
  const Network cut = network_of(map);
  EXPECT_EQ(cut.overshoots, 1U);
  EXPECT_EQ(cut.nodes.x, 1U);
  EXPECT_EQ(cut.nodes.y, 1U);
  EXPECT_EQ(cut.nodes.i, raw.nodes.i - 1);
  EXPECT_NEAR(cut.length(), raw.length() - 0.1, 1e-12);
  EXPECT_EQ(cut.overlaps, 0U);
}

TEST(TraceNetwork, TheWindowHidesEnds) {
  const Network n = network_of(map_of(ten, {"-5 3 15 3", "5 4 5 12", "2 5 4 5"}));
  ASSERT_EQ(n.pieces.size(), 3U);
  EXPECT_EQ(n.pieces[0].hidden, 2);
  EXPECT_EQ(n.pieces[1].hidden, 1);
  EXPECT_EQ(n.pieces[2].hidden, 0);
  EXPECT_DOUBLE_EQ(n.pieces[0].length, 10.0);
  EXPECT_DOUBLE_EQ(n.pieces[1].length, 6.0);
  EXPECT_EQ(n.nodes.window, 3U);
  EXPECT_EQ(n.nodes.i, 3U);
}

// A U-shaped window shows two parts of one trace.
TEST(TraceNetwork, AConcaveWindowShowsPartsOfATrace) {
  const Network n =
      network_of(map_of("0 0 0 10 3 10 3 4 7 4 7 10 10 10 10 0", {"-1 8 11 8"}));
  ASSERT_EQ(n.pieces.size(), 2U);
  EXPECT_DOUBLE_EQ(n.pieces[0].length, 3.0);
  EXPECT_DOUBLE_EQ(n.pieces[1].length, 3.0);
  EXPECT_EQ(n.nodes.window, 4U);
}

TEST(TraceNetwork, BendsAreNoNodesAndDirectionsAreFromEndToEnd) {
  const Network n = network_of(map_of(ten, {"1 1 5 1 5 5", "2 8 4 8 4 9.5 2 9.5 2 8"}));
  EXPECT_EQ(n.nodes.i, 2U);
  EXPECT_EQ(n.nodes.y + n.nodes.x, 0U);
  ASSERT_EQ(n.pieces.size(), 2U);
  EXPECT_DOUBLE_EQ(n.pieces[0].length, 8.0);
  EXPECT_DOUBLE_EQ(n.pieces[0].direction, 45.0);
  EXPECT_DOUBLE_EQ(n.pieces[1].length, 7.0);  // a loop
  EXPECT_EQ(n.pieces[1].hidden, 0);
}

TEST(TraceNetwork, EndsThatMeetAndOverlapsAreReported) {
  const Network met = network_of(map_of(ten, {"1 1 5 1", "5 1 5 5"}));
  EXPECT_EQ(met.nodes.joined, 1U);
  EXPECT_EQ(met.nodes.i, 2U);
  EXPECT_EQ(met.overlaps, 0U);
  EXPECT_GT(network_of(map_of(ten, {"1 1 5 1", "3 1 8 1"})).overlaps, 0U);
}

// m lines one way and n the other, all through the window: every crossing is an X node,
// and P21 is known.
TEST(TraceNetwork, ASquareLattice) {
  SetNumbers flat{0.0, 0.0, 2.0}, steep{90.0, 0.0, 2.0};
  flat.x0 = steep.x0 = flat.y0 = steep.y0 = 1.0;
  const TraceMap map =
      generated(rectangle(10.0, 10.0), {joint_set(flat), joint_set(steep)}, 1);
  StatisticsOptions options;
  const MapStatistics s = statistics_of(map, options);
  EXPECT_EQ(s.network.nodes.x, 25U);
  EXPECT_EQ(s.network.nodes.i + s.network.nodes.y, 0U);
  EXPECT_EQ(s.network.nodes.window, 20U);
  EXPECT_NEAR(s.density.p21.value, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(s.topology.connections_per_branch, 2.0);
  EXPECT_EQ(s.families.size(), 2U);
  for (const FamilyStatistics& family : s.families) {
    EXPECT_NEAR(family.spacing.mean, 2.0, 1e-12);
    EXPECT_NEAR(family.spacing.variation, 0.0, 1e-12);
  }
}

// Poisson lines: length per area is 1 / space, and the crossings per area are
// P21^2 / pi. The means of 60 maps are within 4 standard errors.
TEST(TraceNetwork, PoissonLines) {
  SetNumbers lines;
  lines.space = 1.0;
  lines.law = geometry::SpacingLaw::poisson;
  lines.x0 = 10.0, lines.y0 = 7.0;
  constexpr int maps = 60;
  constexpr double area = 20.0 * 14.0;
  double length = 0.0, lengths = 0.0, crossings = 0.0, squares = 0.0;
  for (int seed = 1; seed <= maps; ++seed) {
    const Network n = network_of(generated(rectangle(20.0, 14.0), {joint_set(lines)},
                                           static_cast<unsigned>(seed)));
    const double p21 = n.length() / area, x = static_cast<double>(n.nodes.x) / area;
    length += p21 / maps, lengths += p21 * p21 / maps;
    crossings += x / maps, squares += x * x / maps;
  }
  EXPECT_NEAR(length, 1.0, 4.0 * std::sqrt((lengths - length * length) / maps));
  EXPECT_NEAR(crossings, 1.0 / 3.14159265358979,
              4.0 * std::sqrt((squares - crossings * crossings) / maps));
  EXPECT_LT(std::sqrt((lengths - length * length) / maps), 0.05);
}

// Renumbering and reversing traces changes no count.
TEST(TraceNetwork, TheOrderOfTracesHasNoEffect) {
  SetNumbers a{30.0, 10.0, 2.0, 0.5, 5.0, 2.0, 1.0, 0.5};
  SetNumbers b{110.0, 10.0, 2.0, 0.5, 5.0, 2.0, 1.0, 0.5};
  TraceMap map = generated(rectangle(20.0, 15.0), {joint_set(a), joint_set(b)}, 3);
  const Network one = network_of(map);
  std::reverse(map.segments.begin(), map.segments.end());
  for (auto& segment : map.segments) {
    std::swap(segment.from, segment.to);
    segment.id = map.traces + 1 - segment.id;
  }
  const Network other = network_of(map);
  EXPECT_EQ(one.nodes.i, other.nodes.i);
  EXPECT_EQ(one.nodes.x, other.nodes.x);
  EXPECT_EQ(one.nodes.window, other.nodes.window);
  EXPECT_EQ(one.pieces.size(), other.pieces.size());
  EXPECT_EQ(one.branches.size(), other.branches.size());
  EXPECT_NEAR(one.length(), other.length(), 1e-10);
}

TEST(TraceNetwork, RefusesAFaultyWindow) {
  EXPECT_THROW(network_of(map_of("0 0 10 10 10 0 0 10", {"1 1 2 2"})),
               geometry::CutError);
  EXPECT_THROW(network_of(map_of("0 0 10 0 10 10 0 10", {"1 1 2 2"})),
               geometry::CutError);  // anticlockwise
}

}  // namespace
}  // namespace blocks::joints
