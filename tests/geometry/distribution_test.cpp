// Random widths and angles follow the law of docs/distributions.md (report A.2.4,
// A.2.5). Seeds are fixed. Of the samples of that law at least 999 in a thousand pass
// each threshold.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/exact/quad.hpp"
#include "layers.hpp"
#include "statistics.hpp"

namespace blocks::geometry {
namespace {

using exact::random_places;
using exact::Rational;
using testing::ks_distance;

/// One in a thousand samples of a law exceeds this Kolmogorov-Smirnov statistic.
constexpr double once_in_a_thousand = 1.95;

/// Ratios of width to height, layer by layer.
using Widths = std::vector<std::vector<double>>;

Widths sample(int blocks, const Rational& length_to_height, std::uint64_t seed,
              int layers) {
  Widths widths;
  for (int k = 0; k < layers; ++k) {
    const auto places =
        random_places(blocks, length_to_height, {seed, static_cast<std::uint64_t>(k)});
    std::vector<double> layer;
    for (std::size_t i = 1; i < places.size(); ++i)
      layer.push_back(CGAL::to_double((places[i] - places[i - 1]) * length_to_height));
    widths.push_back(std::move(layer));
  }
  return widths;
}

std::vector<double> block(const Widths& widths, std::size_t i) {
  std::vector<double> result;
  for (const auto& layer : widths)
    result.push_back(layer[i]);
  return result;
}

/// Samples the documented law in doubles, with another random generator.
Widths law(int blocks, double length_to_height, unsigned seed, int layers) {
  std::mt19937_64 engine(seed);
  const double n = blocks;
  Widths widths;
  for (int k = 0; k < layers; ++k) {
    std::vector<double> u;
    double sum = 0.0;
    for (int i = 0; i < blocks; ++i) {
      u.push_back(std::ldexp(static_cast<double>(engine() >> 11U), -53));
      sum += u.back();
    }
    for (double& x : u)
      x = 0.2 * n + 2.8 * sum > length_to_height
              ? 0.2 + (length_to_height - 0.2 * n) * x / sum
              : 3.0 - (3.0 * n - length_to_height) * (1.0 - x) / (n - sum);
    widths.push_back(std::move(u));
  }
  return widths;
}

TEST(RandomWidths, KeepLimitsAndSumExactly) {
  const Rational low(1, 5);
  const Rational high(3);
  for (const int blocks : {1, 2, 3, 17, 150})
    // Mean widths go from the lower limit to the upper one.
    for (int part = 0; part <= 20; ++part) {
      const Rational length =
          Rational(blocks) * (low + (high - low) * Rational(part, 20));
      for (std::uint64_t k = 0; k < 10; ++k) {
        const auto places = random_places(blocks, length, {k, 4});
        ASSERT_EQ(places.size(), static_cast<std::size_t>(blocks) + 1);
        EXPECT_EQ(places.front(), 0);
        EXPECT_EQ(places.back(), 1);
        for (std::size_t i = 1; i < places.size(); ++i) {
          const Rational width = (places[i] - places[i - 1]) * length;
          ASSERT_TRUE(low <= width && width <= high) << blocks << ' ' << part;
        }
      }
    }
}

// Rounding changes each width by at most one unit in the last place of the largest
// coordinate. Neighbours share their side, so the sum of the widths stays exact.
TEST(RandomWidths, AreRoundedByAtMostOneUnitInTheLastPlace) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    LayerRequest request = testing::random_layer("0.1 0 0.1 0.7 70.3 0.7 70.3 0", 60);
    request.stream = {9, k};
    const Layer layer = cut_layer(request);
    const auto places =
        random_places(60, Rational(702, 7), request.stream);  // This is 70.2 / 0.7.
    const Rational unit(
        std::ldexp(1.0, 6 - 52));  // This is the unit of numbers from 64 to 128.
    for (std::size_t i = 0; i < 60; ++i) {
      const auto c = testing::cell(layer, i);
      const Rational width = Rational(c[3].x()) - Rational(c[0].x());
      const Rational drawn = (places[i + 1] - places[i]) * Rational(702, 10);
      EXPECT_TRUE(CGAL::abs(width - drawn) <= unit);
    }
    EXPECT_EQ(testing::cell(layer, 59)[3].x(), 70.3);
  }
}

TEST(RandomWidths, FollowTheDocumentedLaw) {
  // With few blocks, scaling towards a limit changes the widths most. Both branches of
  // the law occur.
  for (const auto& [blocks, tenths] :
       {std::pair(2, 14), std::pair(2, 45), std::pair(5, 30), std::pair(5, 80),
        std::pair(12, 192)}) {
    const auto ours = sample(blocks, Rational(tenths, 10), 21, 8000);
    const auto theirs = law(blocks, tenths / 10.0, 22, 8000);
    const std::size_t middle = static_cast<std::size_t>(blocks) / 2;
    EXPECT_LT(ks_distance(block(ours, middle), block(theirs, middle)),
              once_in_a_thousand)
        << blocks << ' ' << tenths;
  }
}

TEST(RandomWidths, AreUniformAboutTheirMeanInLongLayers) {
  // With mean r, widths are uniform on r -+ min(r - 0.2, 3 - r). The ends of that
  // interval vary by 1 / sqrt(3 n), which 20 layers of 5000 blocks average out.
  for (const int tenths : {5, 16, 24}) {
    const double mean = tenths / 10.0;
    const double half = std::min(mean - 0.2, 3.0 - mean);
    const auto widths = sample(5000, Rational(tenths * 500), 31, 20);
    std::vector<double> all;
    for (const auto& layer : widths)
      all.insert(all.end(), layer.begin(), layer.end());
    double square = 0.0;
    for (const double w : all)
      square += (w - mean) * (w - mean) / static_cast<double>(all.size());
    EXPECT_NEAR(std::sqrt(square) / (half / std::sqrt(3.0)), 1.0, 0.01) << tenths;
    const auto uniform = [&](double w) {
      return std::clamp((w - mean + half) / (2.0 * half), 0.0, 1.0);
    };
    EXPECT_LT(ks_distance(all, uniform), once_in_a_thousand) << tenths;
  }
}

TEST(RandomWidths, DoNotDependOnThePlaceInTheLayer) {
  constexpr int blocks = 20;
  constexpr int layers = 4000;
  const auto widths = sample(blocks, Rational(24), 41, layers);
  constexpr double mean = 1.2;
  double variance = 0.0;
  std::vector<double> deviation(blocks, 0.0);
  for (const auto& layer : widths)
    for (std::size_t i = 0; i < blocks; ++i) {
      variance += (layer[i] - mean) * (layer[i] - mean) / (blocks * layers);
      deviation[i] += (layer[i] - mean) / layers;
    }
  // Widths are exchangeable with a fixed sum. Chi-square with 19 degrees of freedom
  // exceeds 50.8 once in 10^4.
  double chi_square = 0.0;
  for (const double d : deviation)
    chi_square += d * d * layers / (variance * blocks / (blocks - 1.0));
  EXPECT_LT(chi_square, 50.8);
  EXPECT_LT(ks_distance(block(widths, 0), block(widths, 10)), once_in_a_thousand);
  EXPECT_LT(ks_distance(block(widths, 19), block(widths, 10)), once_in_a_thousand);
}

TEST(RandomWidths, AreCorrelatedOnlyByTheirSum) {
  // The correlation of any two of n blocks with a fixed sum is -1 / (n - 1).
  constexpr int blocks = 10;
  constexpr int layers = 8000;
  const auto widths = sample(blocks, Rational(12), 51, layers);
  for (const std::size_t lag : {1U, 2U, 5U}) {
    double product = 0.0;
    double square = 0.0;
    for (const auto& layer : widths)
      for (std::size_t i = 0; i < blocks; ++i) {
        product += (layer[i] - 1.2) * (layer[(i + lag) % blocks] - 1.2);
        square += (layer[i] - 1.2) * (layer[i] - 1.2);
      }
    // The standard error of 80,000 products is 1 / sqrt(80000) = 0.0035.
    EXPECT_NEAR(product / square, -1.0 / (blocks - 1), 0.0117) << lag;
  }
}

TEST(RandomAngles, AreUniformIfNoSideIsRedrawn) {
  // Blocks are at least 2.8 heights wide, so no side meets another at 30 degrees.
  std::vector<double> angles;
  for (std::uint64_t k = 0; k < 40; ++k) {
    LayerRequest request =
        testing::random_layer("0 0 0 1 870 1 870 0", 300, "-10", "30");
    request.stream = {61, k};
    const Layer layer = cut_layer(request);
    EXPECT_EQ(layer.redrawn, 0);
    EXPECT_EQ(layer.ruled, 0);
    for (std::size_t i = 1; i < layer.mesh.cells.size(); ++i) {
      const auto c = testing::cell(layer, i);
      const Vec2 side = c[1] - c[0];
      angles.push_back(std::atan2(-side.x(), side.y()) * 180.0 / std::numbers::pi);
    }
  }
  EXPECT_LT(
      ks_distance(angles, [](double a) { return std::clamp((a + 10) / 40, 0.0, 1.0); }),
      once_in_a_thousand);
  // An angle does not depend on the one before it. The standard error of the
  // correlation is 0.009.
  double product = 0.0;
  for (std::size_t i = 1; i < angles.size(); ++i)
    product += (angles[i] - 10.0) * (angles[i - 1] - 10.0);
  EXPECT_NEAR(product / static_cast<double>(angles.size()) / (1600.0 / 12.0), 0.0,
              0.03);
}

}  // namespace
}  // namespace blocks::geometry
