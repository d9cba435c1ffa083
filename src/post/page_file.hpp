// A page drawn with cairo becomes a PNG, SVG or PDF file, whole or not at all.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>

namespace blocks::post {

/// width, height: pixels (PNG) or points (SVG, PDF). The ending of the path chooses the
/// format; an older file is kept as NAME.bak. Throws std::runtime_error: unknown
/// ending; output::FileError: file not writable.
void write_page(const std::string& path, double width, double height,
                const std::function<void(cairo_t*)>& draw);

/// Gives a file written as `draft` its name; an older one is kept as NAME.bak. Throws
/// output::FileError.
void take_name(const std::string& draft, const std::string& path);

}  // namespace blocks::post
