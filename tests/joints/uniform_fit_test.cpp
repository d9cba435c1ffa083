// Uniform laws and spacings: estimates and the coverage of their intervals.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/random.hpp"
#include "joints/spacing_fit.hpp"
#include "joints/uniform_fit.hpp"

namespace blocks::joints {
namespace {

double uniform(std::uint64_t seed, std::uint64_t i) {
  return (static_cast<double>(geometry::random_53_bits({seed, 9}, i, 0, 0)) + 0.5) *
         0x1p-53;
}

bool covers(const Estimate& one, double value) {
  return one.low <= value && value <= one.high;
}

/// With 400 samples and 95 %, the number that covers is binomial: 4 deviations are 4.4
/// %.
void expect_coverage(int covered, int samples) {
  EXPECT_GT(covered, 0.905 * samples);
  EXPECT_LT(covered, 0.995 * samples);
}

TEST(UniformFit, IntervalsCoverLocationAndScale) {
  for (const int n : {4, 30}) {
    constexpr int samples = 400;
    int mean = 0, half = 0;
    for (unsigned seed = 1; seed <= samples; ++seed) {
      UniformSample sample;
      sample.min = -HUGE_VAL;
      for (int i = 0; i < n; ++i)
        sample.values.push_back(5.0 + 2.0 * (2.0 * uniform(seed, i) - 1.0));
      const UniformFit fit = fit_uniform(sample);
      mean += covers(fit.mean, 5.0) ? 1 : 0;
      half += covers(fit.half_range, 2.0) ? 1 : 0;
    }
    expect_coverage(mean, samples);
    expect_coverage(half, samples);
  }
}

// For a complete sample, range / (2 half_range) has the beta distribution (n - 1, 2),
// of which n = 3 gives a cubic with known quantiles: 3 x^2 - 2 x^3 = p.
TEST(UniformFit, ThreeValuesAgainstTheBetaDistribution) {
  UniformSample sample;
  sample.values = {1.0, 1.4, 2.0};
  sample.min = -HUGE_VAL;
  const UniformFit fit = fit_uniform(sample);
  const auto probability = [](double half_range) {
    const double x = 1.0 / (2.0 * half_range);
    return 3.0 * x * x - 2.0 * x * x * x;
  };
  EXPECT_NEAR(probability(fit.half_range.low), 0.975, 0.005);
  EXPECT_NEAR(probability(fit.half_range.value), 0.5, 0.02);
  EXPECT_NEAR(probability(fit.half_range.high), 0.025, 0.005);
}

TEST(UniformFit, EqualValuesHaveNoRange) {
  const UniformFit fit = fit_uniform({{2.0, 2.0 + 1e-9, 2.0}, 1e-6, 0.0, {}});
  EXPECT_NEAR(fit.mean.value, 2.0, 1e-8);
  EXPECT_EQ(fit.half_range.value, 0.0);
  EXPECT_TRUE(std::isinf(fit.log_evidence));
}

TEST(UniformFit, OneValueTellsNothing) {
  EXPECT_TRUE(std::isnan(fit_uniform({{2.0}, 1e-6, 0.0, {}}).mean.value));
}

/// Tracks on a line of this length that begins at a random place.
SpacingSample tracks(double length, unsigned seed, bool exponential) {
  SpacingSample sample;
  sample.length = length;
  double place = -40.0, last = 0.0;
  for (unsigned i = 0; place <= length; ++i) {
    const double u = uniform(seed, i);
    place += exponential ? -2.0 * std::log(u) : 1.5 + u;
    if (place < 0.0 || place > length)
      continue;
    (sample.tracks++ == 0 ? sample.beyond : sample.spacings).push_back(place - last);
    last = place;
  }
  sample.beyond.push_back(length - last);
  return sample;
}

TEST(SpacingFit, RecoversTheLawAndItsMean) {
  for (const bool exponential : {false, true}) {
    constexpr int samples = 400;
    int law = 0, mean = 0, half = 0;
    for (unsigned seed = 1; seed <= samples; ++seed) {
      const SpacingFit fit = fit_spacing(tracks(40.0, seed, exponential));
      law += fit.exponential == exponential ? 1 : 0;
      mean += covers(fit.mean, 2.0) ? 1 : 0;
      half += covers(fit.half_range, 0.5) ? 1 : 0;
    }
    EXPECT_GT(law, 0.9 * samples) << exponential;
    expect_coverage(mean, samples);
    if (!exponential)
      expect_coverage(half, samples);
  }
}

TEST(SpacingFit, NoTracks) { EXPECT_TRUE(std::isnan(fit_spacing({}).mean.value)); }

}  // namespace
}  // namespace blocks::joints
