// Writes the scenes of a report as one table and one chart.
#pragma once

#include <string>

#include "report.hpp"

namespace blocks::bench {

/// Returns the heading of the Markdown table.
std::string heading_of_scenes();

/// Returns the rows of a part below that heading, one for each scene and state.
std::string rows_of_scenes(const Report& report, const std::string& part);

/// Draws the rows of all parts: the phases of a step as bars, ratios of codes as marks.
/// Returns false if there are none. Throws what draw::write_page throws.
bool draw_scenes(const Report& report, const std::string& path);

}  // namespace blocks::bench
