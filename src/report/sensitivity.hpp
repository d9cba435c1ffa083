// The Sobol indices of the measures of a sweep with a Sobol design.
#pragma once

#include <string>
#include <vector>

#include "report/ensemble.hpp"
#include "report/sobol_indices.hpp"

namespace blocks::report {

/// The indices of one sweep.
struct Sensitivity {
  std::size_t member = 0;                ///< index of the sweep
  std::size_t group = 0;                 ///< index of the group of its runs
  std::vector<std::string> parameters;   ///< fields of its design
  std::vector<SobolIndices> quantities;  ///< (columns)
};

/// Returns the indices of each sweep that has a Sobol design. A row with a run that is
/// not done, or has no value, does not count for a measure.
std::vector<Sensitivity> sensitivities(const Ensemble& ensemble);

/// Returns "60 of 64 rows; 4 are left out, because a run has no value".
std::string rows_words(const SobolIndices& indices);

/// Returns the indices of all measures as tables for the terminal.
std::string sensitivity_text(const Ensemble& ensemble,
                             const std::vector<Sensitivity>& all);

}  // namespace blocks::report
