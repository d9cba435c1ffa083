#include "post/figure/symbols.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace blocks::post {

using namespace draw;

void hatch(Pen& pen, const Colour& ground) {
  cairo_t* cairo = pen.cairo();
  double x0, y0, x1, y1, left, top, right, bottom;
  cairo_path_extents(cairo, &x0, &y0, &x1, &y1);
  cairo_clip_extents(cairo, &left, &top, &right, &bottom);
  cairo_path_t* outline = cairo_copy_path(cairo);
  cairo_save(cairo);
  cairo_clip(cairo);
  constexpr double gap = 9.0;
  // Limit the hatching to the page, for blocks much larger than it.
  x0 = std::max(x0, left), x1 = std::min(x1, right);
  y0 = std::max(y0, top), y1 = std::min(y1, bottom);
  for (double x = std::floor((x0 - (y1 - y0)) / gap) * gap; x < x1; x += gap) {
    cairo_move_to(cairo, x, y1);
    cairo_line_to(cairo, x + (y1 - y0), y0);
  }
  const bool dark = is_dark(ground);
  pen.stroke(1.0, dark ? white : Colour{0.1, 0.1, 0.1}, dark ? 0.45 : 0.35);
  cairo_restore(cairo);
  cairo_append_path(cairo, outline);
  cairo_path_destroy(outline);
}

void draw_plane(Pen& pen, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  constexpr double gap = 9.0, stroke = 6.0;
  cairo_t* const cairo = pen.cairo();
  const double length = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length;
  // On a page, y points downwards.
  const Eigen::Vector2d slanted =
      stroke * (Eigen::Vector2d(-along.y(), along.x()) - along);
  pen.line(from.x(), from.y(), to.x(), to.y(), 1.4, ink);
  for (double at = gap; at <= length; at += gap) {
    const Eigen::Vector2d foot = from + at * along;
    cairo_move_to(cairo, foot.x(), foot.y());
    cairo_rel_line_to(cairo, slanted.x(), slanted.y());
  }
  pen.stroke(0.8, ink);
}

void draw_water_sign(Pen& pen, double x, double y) {
  constexpr double half = 6.0, high = 10.0;
  cairo_t* cairo = pen.cairo();
  cairo_move_to(cairo, x, y);
  cairo_line_to(cairo, x - half, y - high);
  cairo_line_to(cairo, x + half, y - high);
  cairo_close_path(cairo);
  pen.fill_and_stroke(paper, 1.4, water_colour);
  for (const auto& [wide, down] : {std::pair{5.0, 4.0}, {2.5, 7.0}})
    pen.line(x - wide, y + down, x + wide, y + down, 1.2, water_colour);
}

}  // namespace blocks::post
