// The data of the page of `blocks view`, packed for the browser. It has the outlines
// once, then for each frame six digits of every quantity of every block, and the
// contact forces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/read/results_reader.hpp"

namespace blocks::post {

struct ViewData {
  std::string meta;    ///< JSON: title, times, quantities, position of each array
  std::string packed;  ///< arrays (view_store.hpp)
};

/// Returns every `every`-th frame and the last. A number is stored as the float nearest
/// to its six leading decimal digits. So the page shows the same six digits as the
/// file. Contact forces are for drawing only (view_forces.hpp). `mirror` is the x [L]
/// of the symmetry plane of a half model; the page can then show the other half. Throws
/// std::runtime_error if an outline changes by more than translation, rotation and
/// uniform strain, unless the block has split.
ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<double>& mirror = {});

}  // namespace blocks::post
