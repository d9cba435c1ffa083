// What the page of `blocks view` carries: outlines once, then for each frame six digits
// of every quantity of every block, and the contact forces; packed for the browser.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

struct ViewData {
  std::string meta;    ///< JSON: title, times, quantities, where each array stands
  std::string packed;  ///< arrays, deflated, in base64
};

/// Every `every`-th frame and the last. A number is stored as the float nearest to its
/// six leading decimal digits, which a float keeps: what the page shows to six digits
/// is the file's number, digit for digit. Of a contact force the page has the direction
/// to 1.5 degrees and the size to 3 %, for drawing. Throws std::runtime_error when a
/// block changes its outline other than by moving, turning and straining evenly.
ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<Units>& units);

/// The float nearest to the six leading digits of the value: "%.6g" of both is the same
/// for 1e-37 < |value| < 3e38; what is smaller becomes zero.
float six_digits(double value);

}  // namespace blocks::post
