// `blocks view`: writes one self-contained HTML page that plays a run.
#pragma once

#include <string>

#include "post/page/view_data.hpp"

namespace blocks::post {

/// The texts of page.html, page.css, and of the scripts of src/post/page/view/, in the
/// order of src/post/CMakeLists.txt.
extern const char* const view_html;
extern const char* const view_css;
extern const char* const view_js;

/// Returns the page with style, scripts and data inserted.
std::string view_page(const ViewData& data);

}  // namespace blocks::post
