// `blocks view`: one HTML page that plays a run, with everything in it.
#pragma once

#include <string>

#include "post/view_data.hpp"

namespace blocks::post {

/// src/post/view/page.html, .css; draft.js and page.js, as they are.
extern const char* const view_html;
extern const char* const view_css;
extern const char* const view_js;

/// The page with style, script and data in their places.
std::string view_page(const ViewData& data);

}  // namespace blocks::post
