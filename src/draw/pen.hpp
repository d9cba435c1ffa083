// Draws lines and text of the figures in the units of the page.
#pragma once

#include <cairo.h>

#include <initializer_list>
#include <string>

#include "draw/colour_map.hpp"
#include "draw/number_text.hpp"
#include "draw/page_size.hpp"
#include "draw/svg_text.hpp"

namespace blocks::draw {

constexpr Colour ink{0.16, 0.16, 0.18}, muted{0.36, 0.36, 0.4}, faint{0.62, 0.62, 0.64},
    white{1, 1, 1}, paper = white;

class Pen {
 public:
  Pen(cairo_t* cairo, const PageSize& page);

  cairo_t* cairo() const { return cairo_; }
  void colour(const Colour& c, double alpha = 1.0);
  /// Paints the whole page white.
  void clear();
  /// These draw the current path and end it.
  void fill(const Colour& c, double alpha = 1.0);
  void stroke(double width, const Colour& c, double alpha = 1.0);
  void fill_and_stroke(const Colour& inside, double width, const Colour& outline);
  /// Draws a line from (x0, y0) to (x1, y1).
  void line(double x0, double y0, double x1, double y1, double width, const Colour& c,
            double alpha = 1.0);
  /// Sets the lengths of dashes and gaps; empty: a solid line.
  void dashes(std::initializer_list<double> lengths);
  /// `along` and `up` choose the anchor of the text at (x, y): 0 is left or top, 1 is
  /// right or bottom. Text longer than `width` is made smaller, down to the smallest
  /// letters of the page, and then cut.
  void text(const std::string& text, double x, double y, double size, const Colour& c,
            double along, double up, double width = unlimited);
  /// Returns the width of a text, as text() draws it.
  double width(const std::string& words, double size) {
    return measure(with_minus_signs(words), size).width;
  }
  /// Draws text from (x, y) on the base line, whatever the heights of its letters.
  void text_on_line(const std::string& words, double x, double y, double size,
                    const Colour& c);
  /// Breaks text into lines of width `width`; a unit in brackets is not broken. Returns
  /// the height used.
  double paragraph(const std::string& words, double x, double y, double size,
                   const Colour& c, double width);
  /// Draws text centred at (x, y) with a rim in the background colour, readable over
  /// lines.
  void label(const std::string& text, double x, double y, double size, const Colour& c,
             const Colour& ground);
  /// Draws text centred at (x, y), turned to read upwards.
  void upright(const std::string& text, double x, double y, double size,
               const Colour& c, double width);
  /// Draws text in a filled box, readable on any background; (x, y) is the middle of
  /// its left edge.
  void tag(const std::string& text, double x, double y, const Colour& c);

 private:
  static constexpr double unlimited = 1e9;
  double letters(double size) const;
  cairo_text_extents_t measure(const std::string& words, double size);
  void put(const TextLine& line);
  std::string fitted(std::string words, double size, double width);
  cairo_t* cairo_;
  const PageSize page_;
};

}  // namespace blocks::draw
