// The style of the pages of a report.
#pragma once

#include <string>

namespace blocks::report {

extern const char* const page_style;   ///< CSS
extern const char* const page_script;  ///< sorts tables; nothing else needs it

/// Returns an SVG picture for a page with several of them: without XML declaration, and
/// with its identifiers preceded by `prefix`. Other texts remain.
std::string unique_ids(std::string svg, const std::string& prefix);

}  // namespace blocks::report
