// Mean trace length and density: unbiased for windows of any shape, whatever they hide.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/random.hpp"
#include "joints/mean_length.hpp"
#include "joints/window.hpp"
#include "validation/traces/maps.hpp"

namespace blocks::joints {
namespace {

using testing::decimal;

/// Traces whose centres are a Poisson process of this density in a region far beyond
/// the window, with exponential lengths. low, high: range of their directions.
struct Disc {
  double density, mean, low, high;
};

TraceMap random_traces(const std::vector<geometry::DecimalPoint>& window,
                       const Disc& law, std::uint64_t seed) {
  TraceMap map;
  map.name = "random";
  map.window = window;
  std::uint64_t drawn = 0;
  const auto uniform = [&] {
    return (static_cast<double>(geometry::random_53_bits({seed, 11}, ++drawn, 0, 0)) +
            0.5) *
           0x1p-53;
  };
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (const auto& corner : window) {
    const double p[2] = {corner.x.value(), corner.y.value()};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
  }
  const double margin = 10.0 * law.mean;  // longer traces are one in 20000
  const double wide = high[0] - low[0] + 2.0 * margin;
  const double tall = high[1] - low[1] + 2.0 * margin;
  // Exponential distances of the traces along a line make a Poisson number.
  for (double at = -std::log(uniform()); at < law.density * wide * tall;
       at -= std::log(uniform())) {
    const geometry::Vec2 middle(low[0] - margin + wide * uniform(),
                                low[1] - margin + tall * uniform());
    const double half = -0.5 * law.mean * std::log(uniform());
    const geometry::Vec2 run =
        half * unit_vector(law.low + (law.high - law.low) * uniform());
    map.segments.push_back({geometry::ExactPoint(geometry::Vec2(middle - run)),
                            geometry::ExactPoint(geometry::Vec2(middle + run)),
                            ++map.traces});
  }
  return map;
}

/// A mean with its standard error.
class Mean {
 public:
  void add(double value) { ++n_, sum_ += value, squares_ += value * value; }
  double value() const { return sum_ / n_; }
  double error() const {
    return std::sqrt((squares_ / n_ - value() * value()) / (n_ - 1.0));
  }

 private:
  double n_ = 0.0, sum_ = 0.0, squares_ = 0.0;
};

void expect_mean(const Mean& found, double exact, double max_error,
                 const std::string& what) {
  EXPECT_LT(found.error(), max_error * exact) << what;
  EXPECT_NEAR(found.value(), exact, 4.0 * found.error() + 0.01 * exact) << what;
}

// A window that is as small as the traces, a slanted triangle, and one that is concave.
// Ratios of sums over all maps are unbiased.
TEST(TraceLengths, UnbiasedForAnyWindow) {
  const std::vector<std::string> windows = {"0 0 0 4 12 4 12 0", "0 0 3 9 12 2",
                                            "0 0 0 9 3 9 3 4 6 4 6 9 9 9 9 0"};
  for (const std::string& text : windows) {
    const auto window = testing::points(text);
    const Disc law{0.2, 4.0, 20.0, 60.0};
    Mean p20, p21, exponential;
    std::vector<Piece> all;
    geometry::Polygon corners;
    for (unsigned seed = 1; seed <= 60; ++seed) {
      const Network n = network_of(random_traces(window, law, seed));
      const TraceDensity density = trace_density(n.pieces, n.window);
      p20.add(density.p20.value);
      p21.add(density.p21.value);
      all.insert(all.end(), n.pieces.begin(), n.pieces.end());
      corners = n.window;
    }
    expect_mean(p20, law.density, 0.04, text + ", P20");
    expect_mean(p21, law.density * law.mean, 0.04, text + ", P21");
    const TraceDensity pooled = trace_density(all, corners);
    EXPECT_NEAR(pooled.by_ends.value, law.mean, 0.07 * law.mean) << text;
    EXPECT_NEAR(pooled.by_counts.value, law.mean, 0.07 * law.mean) << text;
    const FittedLaw fitted =
        fit_length_law(LengthForm::exponential, length_sample(all, corners));
    EXPECT_NEAR(fitted.law.mean, law.mean, 0.05 * law.mean) << text;
    // What the window shows is much shorter than the traces are.
    double visible = 0.0;
    for (const Piece& piece : all)
      visible += piece.length / static_cast<double>(all.size());
    EXPECT_LT(visible, 0.75 * law.mean) << text;
  }
}

// For a circle of radius r the estimate by counts is pi r / 2 * hidden / visible ends.
TEST(TraceLengths, ByCountsInACircle) {
  geometry::Polygon circle;
  constexpr int corners = 720;
  constexpr double r = 3.0;
  for (int k = 0; k < corners; ++k) {
    const geometry::Vec2 u = unit_vector(-360.0 * k / corners);
    circle.push_back(r * u);
  }
  std::vector<Piece> pieces(5);
  pieces[0].hidden = 2;
  pieces[1].hidden = pieces[2].hidden = 1;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces[i].direction = 37.0 * static_cast<double>(i);
  EXPECT_NEAR(trace_density(pieces, circle).by_counts.value,
              0.5 * std::numbers::pi * r * 4.0 / 6.0, 1e-3);
}

// Traces shorter than 1 are left out of the map. The laws correct for it.
TEST(TraceLengths, TruncationIsCorrected) {
  const Disc law{0.3, 2.0, 0.0, 180.0};
  std::vector<Piece> kept;
  geometry::Polygon corners;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Network n = network_of(random_traces(testing::rectangle(12, 9), law, seed));
    for (const Piece& piece : n.pieces)
      if (piece.length >= 1.0)
        kept.push_back(piece);
    corners = n.window;
  }
  const FittedLaw naive =
      fit_length_law(LengthForm::exponential, length_sample(kept, corners));
  const FittedLaw fitted =
      fit_length_law(LengthForm::exponential, length_sample(kept, corners, 1.0));
  EXPECT_GT(naive.law.mean, 1.15 * law.mean);
  EXPECT_NEAR(fitted.law.mean, law.mean, 0.08 * law.mean);
}

// Of 200 maps, the intervals cover the mean and the density as often as they say.
TEST(TraceLengths, CoverageOfTheIntervals) {
  const Disc law{0.3, 2.0, 0.0, 180.0};
  constexpr int maps = 200;
  int laslett = 0, by_ends = 0, p20 = 0, p21 = 0;
  for (unsigned seed = 1; seed <= maps; ++seed) {
    const Network n = network_of(random_traces(testing::rectangle(12, 9), law, seed));
    const auto covers = [](const Estimate& one, double value) {
      return one.low <= value && value <= one.high ? 1 : 0;
    };
    const TraceDensity density = trace_density(n.pieces, n.window);
    laslett += covers(
        fit_length_law(LengthForm::exponential, length_sample(n.pieces, n.window)).mean,
        law.mean);
    by_ends += covers(density.by_ends, law.mean);
    p20 += covers(density.p20, law.density);
    p21 += covers(density.p21, law.density * law.mean);
  }
  for (const int covered : {laslett, by_ends, p20, p21}) {
    EXPECT_GE(covered, 178);  // 190 expected, less 4 deviations
    EXPECT_LE(covered, 200);
  }
}

TEST(TraceLengths, LognormalIsToldFromExponential) {
  // A sample of lognormal lengths that are all complete.
  LengthSample sample;
  for (int i = 0; i < 200; ++i) {
    const double r = std::sqrt(
        -2.0 *
        std::log(
            (static_cast<double>(geometry::random_53_bits({5, 1}, i, 0, 0)) + 0.5) *
            0x1p-53));
    const double angle = 2.0 * std::numbers::pi * 0x1p-53 *
                         static_cast<double>(geometry::random_53_bits({5, 1}, i, 0, 1));
    sample.complete.push_back(3.0 * std::exp(0.3 * r * std::cos(angle) - 0.045));
  }
  sample.area = 1.0;
  const FittedLaw lognormal = fit_length_law(LengthForm::lognormal, sample);
  EXPECT_LT(lognormal.aic() + 20.0,
            fit_length_law(LengthForm::exponential, sample).aic());
  EXPECT_NEAR(lognormal.law.mean, 3.0, 0.2);
  EXPECT_NEAR(lognormal.law.spread, 0.3, 0.05);
  EXPECT_LT(lognormal.mean.low, 3.0);
  EXPECT_GT(lognormal.mean.high, 3.0);
}

TEST(TraceLengths, WithoutVisibleEndsThereIsNoMean) {
  std::vector<Piece> through(3);
  for (Piece& piece : through)
    piece.hidden = 2, piece.length = 1.0;
  const geometry::Polygon square = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const TraceDensity density = trace_density(through, square);
  EXPECT_TRUE(std::isnan(density.by_ends.value));
  EXPECT_EQ(density.p20.value, 0.0);
  EXPECT_TRUE(
      std::isnan(fit_length_law(LengthForm::exponential, length_sample(through, square))
                     .log_likelihood));
}

// The integrals of densities and survivals, by sums.
TEST(TraceLengths, LawsAreConsistent) {
  for (const LengthLaw law : {LengthLaw{LengthForm::exponential, 2.0, 0.0},
                              LengthLaw{LengthForm::lognormal, 2.0, 0.6},
                              LengthLaw{LengthForm::uniform, 2.0, 1.2}}) {
    constexpr double step = 1e-3;
    for (const double from : {0.001, 1.0, 2.5}) {
      double density = 0.0, survival = 0.0;
      for (double x = from + 0.5 * step; x < 40.0; x += step) {
        density += step * std::exp(law.log_density(x));
        survival += step * std::exp(law.log_survival(x));
      }
      EXPECT_NEAR(std::exp(law.log_survival(from)), density, 2e-3);
      EXPECT_NEAR(std::exp(law.log_excess(from)), survival, 2e-3);
    }
  }
}

}  // namespace
}  // namespace blocks::joints
