// Draws lines and text of the figures on a page that is always 1200 units wide.
#pragma once

#include <cairo.h>

#include <initializer_list>
#include <string>

#include "post/colour_map.hpp"

namespace blocks::post {

constexpr Colour ink{0.16, 0.16, 0.18}, muted{0.36, 0.36, 0.4}, faint{0.62, 0.62, 0.64},
    paper{0.992, 0.99, 0.984}, white{1, 1, 1};

class Pen {
 public:
  static constexpr double page = 1200;

  /// `width` is the width of the page in pixels or points.
  Pen(cairo_t* cairo, double width);

  cairo_t* cairo() const { return cairo_; }
  void colour(const Colour& c, double alpha = 1.0);
  void stroke(double width, const Colour& c, double alpha = 1.0);
  /// Sets the lengths of dashes and gaps; empty: a solid line.
  void dashes(std::initializer_list<double> lengths);
  /// `along` and `up` choose the anchor of the text at (x, y): 0 is left or top, 1 is
  /// right or bottom. Text longer than `room` is made smaller.
  void text(const std::string& text, double x, double y, double size, const Colour& c,
            double along, double up, double room = page);
  /// Breaks text into lines of width `room`; a unit in brackets is not broken. Returns
  /// the height used.
  double paragraph(const std::string& words, double x, double y, double size,
                   const Colour& c, double room);
  /// Draws text centred at (x, y) with a rim in the background colour, readable over
  /// lines.
  void label(const std::string& text, double x, double y, double size, const Colour& c,
             const Colour& ground);
  /// Draws text centred at (x, y), turned to read upwards.
  void upright(const std::string& text, double x, double y, double size,
               const Colour& c, double room);
  /// Draws text in a filled box, readable on any background; (x, y) is the middle of
  /// its left edge.
  void tag(const std::string& text, double x, double y, const Colour& c);

 private:
  double width_of(const std::string& words, double size);
  cairo_t* cairo_;
};

}  // namespace blocks::post
