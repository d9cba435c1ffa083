// Families of directions: recovered from samples of laws that are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/random.hpp"
#include "joints/families.hpp"
#include "joints/family_merging.hpp"

namespace blocks::joints {
namespace {

double uniform(std::uint64_t seed, std::uint64_t i, std::uint32_t use) {
  return (static_cast<double>(geometry::random_53_bits({seed, 7}, i, 0, use)) + 0.5) *
         0x1p-53;
}

/// n normal directions.
std::vector<double> normal(double mean, double deviation, int n, std::uint64_t seed) {
  std::vector<double> found;
  for (int i = 0; i < n; ++i) {
    const double r = std::sqrt(-2.0 * std::log(uniform(seed, i, 0)));
    found.push_back(mean + deviation * r *
                               std::cos(2.0 * std::numbers::pi * uniform(seed, i, 1)));
  }
  return found;
}

std::vector<double> even(double low, double high, int n, std::uint64_t seed) {
  std::vector<double> found;
  for (int i = 0; i < n; ++i)
    found.push_back(low + (high - low) * uniform(seed, i, 2));
  return found;
}

std::vector<double> both(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Families, TwoFamiliesOneOfThemAboutTheXAxis) {
  int right = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Mixture m = find_families(
        both(normal(0.0, 8.0, 120, seed), normal(75.0, 5.0, 60, seed + 100)));
    if (m.families.size() != 2)
      continue;
    ++right;
    // 0 and 180 degrees are the same axis.
    std::vector<double> means = {m.families[0].mean, m.families[1].mean};
    for (double& one : means)
      one = one > 170.0 ? one - 180.0 : one;
    std::sort(means.begin(), means.end());
    EXPECT_NEAR(means[0], 0.0, 3.0);
    EXPECT_NEAR(means[1], 75.0, 3.0);
  }
  EXPECT_GE(right, 19);
}

// A mixture of von Mises laws needs several components for a uniform law, whose family
// is one nevertheless.
TEST(Families, UniformDirectionsAreOneFamily) {
  int one = 0, split = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Mixture m = find_families(even(-6.0, 6.0, 400, seed));
    one += m.families.size() == 1 ? 1 : 0;
    split += m.components > 1 ? 1 : 0;
  }
  EXPECT_EQ(one, 20);
  EXPECT_GT(split, 0);  // otherwise this test shows nothing
}

TEST(Families, IsotropicDirectionsHaveNone) {
  int none = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    none += find_families(even(0.0, 180.0, 300, seed)).families.empty() ? 1 : 0;
  EXPECT_GE(none, 18);
}

// Scattered directions hide no family, and are none.
TEST(Families, AFamilyAmongScatteredDirections) {
  int right = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Mixture m =
        find_families(both(normal(40.0, 6.0, 150, seed), even(0.0, 180.0, 150, seed)));
    const auto scattered = std::count(m.member.begin(), m.member.end(), -1);
    right += m.families.size() == 1 && std::abs(m.families[0].mean - 40.0) < 3.0 &&
                     scattered > 90 && scattered < 160
                 ? 1
                 : 0;
  }
  EXPECT_GE(right, 18);
}

TEST(Families, EqualDirections) {
  const Mixture m = find_families(
      both(std::vector<double>(20, 35.0), std::vector<double>(10, 110.0)));
  ASSERT_EQ(m.families.size(), 2U);
  EXPECT_NEAR(m.families[0].mean, 35.0, 1e-6);
  EXPECT_NEAR(m.families[1].mean, 110.0, 1e-6);
  EXPECT_NEAR(m.families[0].weight, 2.0 / 3.0, 1e-9);
}

// The concentration of one component by maximum likelihood: kappa is nearly
// 1 / (2 deviation)^2 in radians.
TEST(Families, Concentration) {
  const Mixture m = find_families(normal(40.0, 6.0, 4000, 3), 1);
  const double deviation = 2.0 * 6.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(m.families[0].kappa * deviation * deviation, 1.0, 0.08);
  EXPECT_NEAR(m.families[0].mean, 40.0, 0.5);
}

TEST(Families, TurningAllDirectionsTurnsTheFamilies) {
  const auto given = both(normal(30.0, 8.0, 100, 5), normal(95.0, 8.0, 100, 6));
  std::vector<double> turned = given;
  for (double& one : turned)
    one += 20.0;
  const Mixture a = find_families(given), b = find_families(turned);
  ASSERT_EQ(a.families.size(), 2U);
  ASSERT_EQ(b.families.size(), 2U);
  EXPECT_NEAR(b.families[0].mean - a.families[0].mean, 20.0, 0.2);
  EXPECT_NEAR(b.families[1].mean - a.families[1].mean, 20.0, 0.2);
}

TEST(Families, FewDirections) {
  EXPECT_TRUE(find_families({10.0}).families.empty());
  EXPECT_EQ(find_families({10.0}).member, std::vector<int>{-1});
}

// The closed forms of the evidence against sums over a grid.
TEST(Families, EvidenceIsTheIntegralOfTheLikelihood) {
  const std::vector<double> off = {-2.0, -0.5, 0.3, 1.1, 2.4};
  double normal_sum = 0.0, uniform_sum = 0.0;
  constexpr double step = 0.04;
  for (double mean = -20.0; mean < 20.0; mean += step)
    for (double spread = 0.5 * step; spread < 90.0; spread += step) {
      double squares = 0.0;
      bool inside = true;
      for (const double one : off) {
        squares += (one - mean) * (one - mean);
        inside = inside && std::abs(one - mean) <= spread;
      }
      normal_sum += std::exp(-0.5 * squares / (spread * spread)) /
                    std::pow(std::sqrt(2.0 * std::numbers::pi) * spread, 5.0);
      uniform_sum += inside ? std::pow(2.0 * spread, -5.0) : 0.0;
    }
  const double prior = step * step / (180.0 * 90.0);
  EXPECT_NEAR(family_evidence(off), std::log(prior * std::max(normal_sum, uniform_sum)),
              0.05);
}

}  // namespace
}  // namespace blocks::joints
