// Pen and letters of the figures, on a page 1200 wide whatever its size in pixels.
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

  /// width: of the page in pixels or points.
  Pen(cairo_t* cairo, double width);

  cairo_t* cairo() const { return cairo_; }
  void colour(const Colour& c, double alpha = 1.0);
  void stroke(double width, const Colour& c, double alpha = 1.0);
  /// Lengths of dashes and gaps; none: a full line.
  void dashes(std::initializer_list<double> lengths);
  /// along, up: which part of the text stands at (x, y); 0 left or top, 1 right or
  /// bottom. Text longer than `room` is set smaller.
  void text(const std::string& text, double x, double y, double size, const Colour& c,
            double along, double up, double room = page);
  /// Words on as many lines as `room` asks for; a unit in brackets stays in one piece.
  /// Returns the height used.
  double paragraph(const std::string& words, double x, double y, double size,
                   const Colour& c, double room);
  /// Centred at (x, y), with a rim of the ground's colour: read over lines as well.
  void label(const std::string& text, double x, double y, double size, const Colour& c,
             const Colour& ground);
  /// Centred at (x, y), read from below.
  void upright(const std::string& text, double x, double y, double size,
               const Colour& c, double room);
  /// Text on a piece of paper, readable on any ground; (x, y) is its left middle.
  void tag(const std::string& text, double x, double y, const Colour& c);

 private:
  double width_of(const std::string& words, double size);
  cairo_t* cairo_;
};

}  // namespace blocks::post
