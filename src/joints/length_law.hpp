// Laws of trace lengths, and their likelihood for what a window shows of the traces
// (docs/joint-statistics.md#trace-lengths).
#pragma once

#include <cstddef>
#include <vector>

#include "joints/network.hpp"

namespace blocks::joints {

enum class LengthForm { exponential, lognormal, uniform };

/// A law of the length x > 0 of all traces, each trace counting once.
struct LengthLaw {
  LengthForm form = LengthForm::exponential;
  double mean = 1.0;    ///< [L] > 0
  double spread = 0.0;  ///< lognormal: deviation of ln x; uniform: half range [L] > 0

  double log_density(double x) const;   ///< ln f(x) [1/L]
  double log_survival(double x) const;  ///< ln S(x), the part of longer traces
  double log_excess(double x) const;    ///< ln of the integral of S from x on [L]
};

/// The traces that a window shows, by the number of their hidden ends.
struct LengthSample {
  std::vector<double> complete, one_hidden, both_hidden;  ///< [L] visible lengths
  double shortest = 0.0;  ///< [L] >= 0: shorter traces were not mapped
  double area = 0.0;      ///< [L^2] of the chords beyond `shortest` (ChordMeasure)
  double width = 0.0;     ///< [L] of these chords

  std::size_t size() const {
    return complete.size() + one_hidden.size() + both_hidden.size();
  }
  /// Returns the logarithm of the likelihood
  ///
  ///     product f(x) product S(y) product G(z) / (S(s) area + G(s) width)^n
  ///
  /// x: complete, y: one_hidden, z: both_hidden, G: the integral of S, s: shortest. The
  /// denominator is the expected number of traces that the window shows, per trace and
  /// area. Minus infinity if the law excludes a length.
  double log_likelihood(const LengthLaw& law) const;
};

/// Returns the sample of these pieces; those shorter than `shortest` are left out. The
/// chords are averaged over the directions of the pieces.
LengthSample length_sample(const std::vector<Piece>& pieces,
                           const geometry::Polygon& window, double shortest = 0.0);

}  // namespace blocks::joints
