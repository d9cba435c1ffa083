// The files of the folder page/, which the program contains. A {name} in an HTML file is
// a place of fmt::format.
#pragma once

namespace blocks::report {

extern const char* const page_html;  ///< the page of a report
extern const char* const run_html;   ///< the page of a run that is not played
extern const char* const page_css;   ///< of both
extern const char* const page_js;    ///< sorts tables; nothing else needs it

}  // namespace blocks::report
