// The comparison of all networks with the exact values, for two sets of seeds.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "validation/cells/cases.hpp"

namespace blocks::validation {

inline constexpr double interval_level = 0.95;
/// Part of the sampled cells that may touch the outline. So few do not change a mean by
/// a visible part of its error.
inline constexpr double max_clipped = 1e-5;
/// Probability that a run fails although every exact value is true.
inline constexpr double family_level = 0.01;
inline constexpr std::size_t seed_sets = 2;

/// A quantity with its estimates from each set of seeds.
struct Row {
  std::size_t index;  ///< of the case
  Quantity quantity;
  std::array<Estimate, seed_sets> estimates;

  bool is_inside(std::size_t set) const {
    return std::abs(estimates[set].value - quantity.exact) <=
           estimates[set].half_width(interval_level);
  }
};

struct Study {
  std::vector<Case> cases;
  /// Samples of each case, for each set of seeds.
  std::vector<std::array<std::vector<Sums>, seed_sets>> samples;
  std::vector<Row> rows;

  /// Returns the sum over all networks of a set of seeds.
  double total(std::size_t set, int index) const;
  /// Returns the limit of |z| of a row.
  double limit(const Row& row, std::size_t set) const;
  /// True if each |z| is below its limit, every identity holds and at most
  /// max_clipped of the sampled cells touch the outline.
  bool passed() const;
};

/// Runs this part of the networks of a full run, at least 20 of each case.
Study run_study(double part, int threads);

/// Returns the page with all tables.
std::string markdown(const Study& study);

}  // namespace blocks::validation
