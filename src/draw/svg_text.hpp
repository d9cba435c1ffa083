// Text of an SVG file as text elements, which readers can search and programs can edit.
// Cairo itself writes the outlines of the letters.
#pragma once

#include <cairo.h>

#include <string>

#include "draw/colour_map.hpp"

namespace blocks::draw {

/// A line of text; x, y and size are in the units of the cairo context.
struct TextLine {
  std::string words;
  double x, y;   ///< anchor, on the baseline
  double along;  ///< position of the anchor: 0 begin, 0.5 middle, 1 end
  double size;
  Colour colour;
  double rim = 0.0;  ///< width of the stroke around the letters
  Colour rim_colour;
};

/// Collects the text of a page, and puts it on top of the drawing.
class SvgText {
 public:
  /// Collects the text of this surface, which must exist as long.
  explicit SvgText(cairo_surface_t* surface);
  SvgText(const SvgText&) = delete;
  SvgText& operator=(const SvgText&) = delete;
  ~SvgText();

  /// Returns the collector of the surface that the context draws on; nullptr if text is
  /// drawn with cairo.
  static SvgText* of(cairo_t* cairo);

  /// Adds a line unless its anchor is clipped.
  void add(cairo_t* cairo, const TextLine& line);

  /// Returns the complete SVG page with the text. Throws std::runtime_error if the page
  /// has no end.
  std::string inserted(std::string page) const;

 private:
  cairo_surface_t* surface_;
  std::string elements_;
};

}  // namespace blocks::draw
