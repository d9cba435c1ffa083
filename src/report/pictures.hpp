// Pictures of the blocks of a run, for the pages of a report.
#pragma once

#include <optional>
#include <string>

#include "report/ensemble.hpp"

namespace blocks::report {

/// Returns the first and the last picture of a run: SVG, or an HTML image of a large
/// model.
std::string first_and_last(const Ensemble& ensemble, const RunRow& row,
                           const std::optional<double>& mirror);

/// Returns the last picture of a run.
std::string last_picture(const Ensemble& ensemble, const RunRow& row);

}  // namespace blocks::report
