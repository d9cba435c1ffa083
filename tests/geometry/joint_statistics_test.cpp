// Cells of random networks against their exact means: a short form of
// `./go validate cells`. Seeds are fixed. For other seeds, fewer than one in a thousand
// would fail, because the limit comes from the standard error and the number of rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics.hpp"
#include "validation/cells/cases.hpp"
#include "validation/cells/networks.hpp"

namespace blocks::validation {
namespace {

using namespace geometry;
using geometry::testing::ks_distance;

/// One in a thousand samples of a law exceeds this Kolmogorov-Smirnov statistic.
constexpr double once_in_a_thousand = 1.95;
constexpr double family_level = 0.001;
constexpr std::uint64_t first_seed = 1;

/// Compares all means of a group. The standard error must be at most `error` of the
/// exact value, so a wrong constant is found.
void expect_exact_means(const std::string& group, int networks, double error) {
  const std::vector<Case> all = cases();
  int rows = 0;
  for (const Case& one : all)
    rows += static_cast<int>(one.quantities.size());
  bool found = false;
  for (const Case& one : all) {
    if (one.group.rfind(group, 0) != 0)
      continue;
    found = true;
    const auto sample = samples(one, first_seed, networks, 1);
    for (const Sums& sums : sample) {
      EXPECT_EQ(sums[sum::broken], 0.0) << one.name;
      EXPECT_EQ(sums[sum::clipped], 0.0) << one.name;
    }
    for (const Quantity& quantity : one.quantities) {
      const Estimate mean = jackknife(sample, quantity.statistic);
      EXPECT_LE(std::abs(mean.z(quantity.exact)),
                family_limit(family_level, rows, networks))
          << one.name << ", " << quantity.name << ": " << mean.value << " +- "
          << mean.error << ", exact " << quantity.exact;
      EXPECT_LE(mean.error, error * quantity.exact)
          << one.name << ", " << quantity.name;
    }
  }
  EXPECT_TRUE(found);
}

TEST(JointStatistics, PoissonLines) { expect_exact_means("Poisson lines", 150, 0.1); }

TEST(JointStatistics, TwoExponentialSets) {
  expect_exact_means("Two NEGEXP sets", 50, 0.12);
}

TEST(JointStatistics, TwoUniformSets) {
  expect_exact_means("Two UNIFORM sets", 60, 0.04);
}

TEST(JointStatistics, Persistence) { expect_exact_means("Persistence", 25, 0.06); }

TEST(JointStatistics, PoissonVoronoiCells) {
  expect_exact_means("Poisson Voronoi cells", 25, 0.05);
}

// Cells that the outline cuts are smaller and have other numbers of sides.
TEST(JointStatistics, CellsThatTheOutlineCutsAreFound) {
  constexpr int networks = 10;
  Case one = cases().back();
  ASSERT_EQ(one.group, "Poisson Voronoi cells");
  one.window = {{-1.0, -1.0}, {100.0, 100.0}};
  const auto sample = samples(one, first_seed, networks, 1);
  EXPECT_GT(sample[0][sum::clipped], 0.0);
  const Quantity& sides = one.quantities[1];
  ASSERT_EQ(sides.name, "E sides");
  EXPECT_GT(std::abs(jackknife(sample, sides.statistic).z(sides.exact)),
            family_limit(family_level, 1, networks));
}

// Lines whose foot is in a circle about the start are made for every direction, so
// their directions and distances are uniform.
TEST(JointStatistics, PoissonLinesAreIsotropicAndUniform) {
  JointSet set;
  set.spacing.mean = decimal(0.01);
  set.law = SpacingLaw::poisson;
  set.start = {decimal(5.0), decimal(5.0)};
  set.stream = {first_seed, 1};
  std::vector<double> directions, distances;
  for (const JointSegment& line : joint_set(set, rectangle(10.0, 10.0))) {
    const Vec2 along = (line.to.nearest() - line.from.nearest()).normalized();
    const double distance = cross(along, Vec2(5.0, 5.0) - line.from.nearest());
    if (std::abs(distance) > 5.0)
      continue;
    directions.push_back(std::atan2(along.y(), along.x()) / std::numbers::pi);
    distances.push_back(distance);
  }
  EXPECT_NEAR(static_cast<double>(directions.size()), 1000.0, 4.0 * std::sqrt(1000.0));
  const auto uniform = [](double u) { return std::clamp(u, 0.0, 1.0); };
  EXPECT_LT(ks_distance(directions, uniform), once_in_a_thousand);
  EXPECT_LT(ks_distance(distances, [&](double d) { return uniform(d / 10.0 + 0.5); }),
            once_in_a_thousand);
}

// The place of the start along a track is like any other place. The interval about it
// is longer than the others on average.
TEST(JointStatistics, TracesCoverTheStartOfATrackLikeAnyOtherPlace) {
  constexpr double height = 100.0, space = 0.025, trace = 1.0, gap = 4.0;
  for (const double x : {0.0, 2.0, 20.0}) {
    JointSet set = distant_set(0.0, space, first_seed, 1);  // the start is at x = 0
    set.trace = {decimal(trace), decimal(0.5)};
    set.gap = {decimal(gap), decimal(4.0)};
    int covered = 0;
    for (const JointSegment& piece : joint_set(
             set, polygon({{x - 1, 0}, {x - 1, height}, {x + 1, height}, {x + 1, 0}})))
      covered += piece.from.nearest().x() <= x && piece.to.nearest().x() > x &&
                         piece.from.nearest().y() > 0.0 &&
                         piece.from.nearest().y() < height
                     ? 1
                     : 0;
    const double tracks = height / space, part = trace / (trace + gap);
    EXPECT_NEAR(covered / tracks, part, 4.0 * std::sqrt(part * (1 - part) / tracks))
        << x;
  }
}

// The jackknife of a mean is the usual standard error.
TEST(JointStatistics, JackknifeOfAMeanIsItsStandardError) {
  std::vector<Sums> sample(4, Sums::Zero(sum::count));
  for (int i = 0; i < 4; ++i) {
    sample[static_cast<std::size_t>(i)][sum::networks] = 1.0;
    sample[static_cast<std::size_t>(i)][sum::faces] = i;
  }
  const Estimate mean =
      jackknife(sample, [](const Sums& s) { return s[sum::faces] / s[sum::networks]; });
  EXPECT_NEAR(mean.value, 1.5, 1e-14);
  EXPECT_NEAR(mean.error, std::sqrt(5.0 / 3.0 / 4.0), 1e-14);
  EXPECT_NEAR(mean.half_width(0.95), 3.18245 * mean.error, 1e-5);  // Student, 3 degrees
  // Ten comparisons at 1 % are one at 0.1 %.
  EXPECT_DOUBLE_EQ(family_limit(0.01, 10, 30), family_limit(0.001, 1, 30));
}

}  // namespace
}  // namespace blocks::validation
