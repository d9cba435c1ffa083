// The names and dimensions of the numbers in outcome.json.
#pragma once

#include <string>

#include "report/run_values.hpp"

namespace blocks::report {

/// Returns the label and the dimension of a measured value: "aspect:max" is "largest
/// aspect ratio of a block". A name that is not known is its own label, without
/// dimension.
MeasureLabel label_of_outcome(const std::string& name);

}  // namespace blocks::report
