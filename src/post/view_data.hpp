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
  std::string packed;  ///< arrays (view_store.hpp)
};

/// Every `every`-th frame and the last. A number is stored as the float nearest to its
/// six leading decimal digits, which a float keeps: what the page shows to six digits
/// is the file's number, digit for digit. Of a contact force the page has the direction
/// to 1.5 degrees and the size to 3 %, for drawing. mirror: x [L] of the plane that a
/// half model ends at; the page can show the other half. Throws std::runtime_error when
/// a block changes its outline other than by moving, turning and straining evenly.
ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<Units>& units,
                   const std::optional<double>& mirror = {});

}  // namespace blocks::post
