#include "draw/marks.hpp"

#include <cairo.h>

#include <cmath>
#include <numbers>

namespace blocks::draw {
namespace {

/// Traces a regular polygon whose first corner is at the angle `turn` from the x axis;
/// y points down.
void trace_polygon(cairo_t* pen, int corners, double turn, double x, double y,
                   double radius) {
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / corners;
    cairo_line_to(pen, x + radius * std::cos(angle), y - radius * std::sin(angle));
  }
  cairo_close_path(pen);
}

}  // namespace

Colour mark_colour(Mark::Kind kind) {
  switch (kind) {
  case Mark::Kind::overlap:
    return {0.84, 0.10, 0.11};
  case Mark::Kind::gap:
    return {0.03, 0.38, 0.72};
  case Mark::Kind::junction:
    return {0.00, 0.50, 0.42};
  case Mark::Kind::slender:
    return {0.90, 0.47, 0.05};
  case Mark::Kind::edge:
    return {0.42, 0.26, 0.10};
  case Mark::Kind::angle:
    return {0.46, 0.17, 0.62};
  }
  return {};
}

void trace_mark(cairo_t* pen, Mark::Kind kind, double x, double y, double radius) {
  constexpr double pi = std::numbers::pi;
  cairo_new_path(pen);
  switch (kind) {
  case Mark::Kind::overlap:
  case Mark::Kind::slender:
    cairo_arc(pen, x, y, radius, 0, 2.0 * pi);
    cairo_close_path(pen);
    break;
  case Mark::Kind::gap:
    trace_polygon(pen, 4, 0.5 * pi, x, y, 1.3 * radius);
    break;
  case Mark::Kind::junction:
    cairo_arc(pen, x, y, 0.5 * radius, 0, 2.0 * pi);
    cairo_close_path(pen);
    break;
  case Mark::Kind::edge:
    trace_polygon(pen, 4, 0.25 * pi, x, y, 1.2 * radius);
    break;
  case Mark::Kind::angle:
    trace_polygon(pen, 3, 0.5 * pi, x, y, 1.5 * radius);
    break;
  }
}

}  // namespace blocks::draw
