// The scenes of a report in one table and one chart: a row for each scene and state.
#pragma once

#include <string>

#include "report.hpp"

namespace blocks::bench {

/// Heading of the Markdown table.
std::string heading_of_scenes();

/// The rows of a part below that heading.
std::string rows_of_scenes(const Report& report, const std::string& part);

/// Draws the rows of all parts: phases of a step as bars, ratios of codes as marks.
/// Returns false when there is none. Throws as post::write_page.
bool draw_scenes(const Report& report, const std::string& path);

}  // namespace blocks::bench
