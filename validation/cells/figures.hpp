// The figures of the page of ./go validate cells.
#pragma once

#include <string>

#include "validation/cells/study.hpp"

namespace blocks::validation {

/// Draws the deviation of every row from its exact value, with 95 % intervals.
void draw_intervals(const Study& study, const std::string& path);

/// Draws the distributions sides.svg, areas.svg, faces.svg and p21.svg, with what is
/// known exactly.
void draw_distributions(const Study& study, const std::string& folder);

/// Draws one network of each kind: poisson_lines.png, negexp.png, uniform.png,
/// persistence.png, voronoi.png.
void draw_pictures(const std::string& folder);

}  // namespace blocks::validation
