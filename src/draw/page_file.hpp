// Writes a page drawn with cairo as a PNG, SVG or PDF file.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>

#include "draw/page_size.hpp"

namespace blocks::draw {

/// Writes the file; it appears only when it is complete. Width and height are in pixels
/// (PNG) or points (SVG, PDF). The extension gives the format. An older file is kept as
/// NAME.bak. Throws std::runtime_error if the extension is unknown, and
/// files::FileError if the file cannot be written.
void write_page(const std::string& path, double width, double height,
                const std::function<void(cairo_t*)>& draw);

/// Writes a page of this height [units]. A printed page is a PNG with its resolution.
/// `draw` works in pixels (PNG on the screen) or points.
void write_page(const std::string& path, const PageSize& page, double height,
                const std::function<void(cairo_t*)>& draw);

/// Returns a page of this height [units] as SVG, for a page that contains it. Throws
/// std::runtime_error if it cannot be drawn.
std::string svg_page(const PageSize& page, double height,
                     const std::function<void(cairo_t*)>& draw);

/// Returns a page of this height [units] as PNG.
std::string png_page(const PageSize& page, double height,
                     const std::function<void(cairo_t*)>& draw);

}  // namespace blocks::draw
