// The design of a sweep from which Sobol indices are computed: Saltelli, Annoni,
// Azzini, Campolongo, Ratto and Tarantola (2010), Computer Physics Communications 181,
// 259-270.
//
// A row of the design has two random points a and b of the box of the parameters, and a
// run at each of
//
//     a,  b,  and for each parameter i the point a with the coordinate i of b.
//
// The points (a, b) of all rows are those of a Sobol sequence in twice as many
// dimensions as there are parameters, with a random digital shift: in each dimension,
// the same random bits are added modulo 2 to the bits of all points. So each point has
// the uniform distribution, and 2^m points are as evenly spread as the sequence is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sweep/axes.hpp"

namespace blocks::sweep {

/// The most parameters of a design.
constexpr std::size_t max_sobol_parameters = 8;

/// A field that is uniformly distributed between both ends.
struct SobolRange {
  std::string field;  ///< "FRICTN.fric"
  double low = 0.0, high = 1.0;

  bool operator==(const SobolRange&) const = default;
};

struct SobolDesign {
  std::vector<SobolRange> ranges;  ///< 1 to max_sobol_parameters, all different
  std::size_t rows = 0;            ///< N, at least 2
  std::uint64_t seed = 0;          ///< of the digital shift

  bool operator==(const SobolDesign&) const = default;

  /// The number of runs of a row: a, b, and one for each parameter.
  std::size_t runs_per_row() const { return ranges.size() + 2; }
  std::size_t runs() const { return rows * runs_per_row(); }
  bool has(const std::string& field) const;
};

/// Reads "CARD.field=low..high,CARD.field=low..high". Throws AxisFault.
std::vector<SobolRange> parse_sobol(const std::string& text);

/// Returns the first `count` points of a Sobol sequence with the digital shift of this
/// seed, each with `dimension` coordinates u, 0 < u < 1.
std::vector<std::vector<double>> sobol_points(std::size_t count, std::size_t dimension,
                                              std::uint64_t seed);

/// Returns the runs of a design, row by row. `common` is what all runs have. Throws
/// AxisFault if it sets a field of the design, or there are more than max_runs.
std::vector<Variation> sobol_runs(const SobolDesign& design, const Variation& common);

/// Returns a run at each corner of the box of the parameters. If a deck accepts every
/// field there, it does so in between.
std::vector<Variation> sobol_corners(const SobolDesign& design,
                                     const Variation& common);

/// Returns "FRICTN.fric = 0.3 to 0.6, STIFF.stifn = 1e+08 to 1e+09".
std::string words_of(const SobolDesign& design);

}  // namespace blocks::sweep
