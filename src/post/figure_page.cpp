#include "post/figure_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/counted.hpp"
#include "post/figure_legend.hpp"
#include "post/scene_drawing.hpp"

namespace blocks::post {
namespace {

constexpr double left = 84, top = 78, right = 150, foot = 64, gap = 22, heading = 34;
constexpr Dimension length{1, 0, 0, "m", ""}, time{0, 0, 1, "s", ""};

}  // namespace

FigurePage::FigurePage(std::size_t count, std::string title, const FigureScales& scales,
                       const FigureOptions& options)
    : count_(count), title_(std::move(title)), scales_(scales), options_(options) {
  const double shape = [&] {
    const Axes one(scales.view, 0, 0, 1);
    return one.height;
  }();
  double best = 1e300;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    if (options.columns > 0 &&
        columns != std::min(static_cast<std::size_t>(options.columns), count))
      continue;
    const auto across = static_cast<double>(columns);
    const auto rows = std::ceil(static_cast<double>(count) / across);
    const double width = (Pen::page - left - right - (across - 1) * gap) / across;
    const double height = top + foot +
                          std::max(rows * (width * shape + (count > 1 ? heading : 0)),
                                   legend_height(scales, options) - 0.5 * foot);
    // Choose the page closest to a landscape sheet, with few empty cells.
    const double empty = across * rows - static_cast<double>(count);
    const double far = std::abs(std::log(height / (0.75 * Pen::page))) + 0.2 * empty;
    if (far >= best)
      continue;
    best = far;
    columns_ = columns;
    width_ = width;
    height_ = height;
  }
}

Axes FigurePage::axes(std::size_t i) const {
  const std::size_t whole_rows = i / columns_;
  const auto column = static_cast<double>(i % columns_);
  const auto row = static_cast<double>(whole_rows);
  Axes result(scales_.view, left + column * (width_ + gap), top, width_);
  if (count_ > 1)
    result.top += heading + row * (result.height + heading);
  return result;
}

void FigurePage::begin(Pen& pen) const {
  pen.colour(paper);
  cairo_paint(pen.cairo());
  pen.text(title_.empty() ? "BLOCKS" : title_, left, 34, 21, ink, 0, 1,
           Pen::page - left - 20);
}

void FigurePage::picture(Pen& pen, std::size_t i, const Picture& picture) const {
  const Axes here = axes(i);
  draw_scene(pen, here, picture, scales_, options_);
  rulers(pen, here, i + columns_ >= count_, i % columns_ == 0);
  const std::string unit = options_.units ? " " + unit_text(time, options_.units) : "";
  const std::string at = fmt::format("t = {:.4g}{}", picture.now.time, unit);
  if (count_ > 1)
    pen.text(at, here.left, here.top - 9, 15, muted, 0, 1);
  else
    pen.text(options_.subtitle.empty()
                 ? fmt::format("{}    step {}    {}", at, picture.now.step,
                               counted(picture.now.outlines.size(), "block"))
                 : options_.subtitle,
             left, 62, 15, muted, 0, 1);
}

void FigurePage::end(Pen& pen, const Picture& last) const {
  const Axes first = axes(0), lowest = axes(count_ - 1);
  const double room = std::max(lowest.bottom(), height_ - 0.5 * foot) - first.top;
  if (count_ > 1)
    pen.text(counted(count_, "time") + "    " +
                 counted(last.now.outlines.size(), "block"),
             left, 62, 15, muted, 0, 1);
  draw_legend(pen,
              {Pen::page - right + 16, first.top,
               lowest.bottom() - first.top < 300 ? room : lowest.bottom() - first.top,
               arrow_length(first, scales_)},
              last, scales_, options_);
}

void FigurePage::rulers(Pen& pen, const Axes& axes, bool along_x, bool along_y) const {
  cairo_t* cairo = pen.cairo();
  cairo_rectangle(cairo, axes.left, axes.top, axes.width, axes.height);
  pen.stroke(1.0, ink);
  const auto tick = [&](double x, double y, double dx, double dy) {
    cairo_move_to(cairo, x, y);
    cairo_rel_line_to(cairo, dx, dy);
    pen.stroke(1.0, ink);
  };
  const TickLabels xs =
      label_ticks(axes.xmin, axes.xmax, std::max(3, static_cast<int>(axes.width / 97)));
  for (std::size_t i = 0; i < xs.ticks.size(); ++i) {
    tick(axes.x(xs.ticks[i]), axes.bottom(), 0, along_x ? 6 : -5);
    if (along_x)
      pen.text(xs.labels[i], axes.x(xs.ticks[i]), axes.bottom() + 11, 14, ink, 0.5, 0);
  }
  const TickLabels ys = label_ticks(axes.ymin, axes.ymax,
                                    std::max(2, static_cast<int>(axes.height / 70)));
  for (std::size_t i = 0; i < ys.ticks.size(); ++i) {
    tick(axes.left, axes.y(ys.ticks[i]), along_y ? -6 : 5, 0);
    if (along_y)
      pen.text(ys.labels[i], axes.left - 11, axes.y(ys.ticks[i]), 14, ink, 1, 0.5, 46);
  }
  if (along_x) {
    pen.text(xs.offset, axes.right(), axes.bottom() + 38, 14, ink, 1, 0);
    pen.text(xs.titled(with_unit("x", length, options_)), axes.left + axes.width / 2,
             axes.bottom() + 38, 15, ink, 0.5, 0);
  }
  if (along_y) {
    pen.text(ys.offset, axes.left - 66, axes.top - 5, 14, ink, 0, 1);
    pen.upright(ys.titled(with_unit("y", length, options_)), axes.left - 66,
                axes.top + axes.height / 2, 15, ink, axes.height);
  }
}

}  // namespace blocks::post
