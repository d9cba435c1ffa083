#include "draw/chart/dot_chart.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "draw/axes.hpp"
#include "draw/line_colours.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"

namespace blocks::draw {
namespace {

constexpr Colour rule{0.9, 0.9, 0.9};

/// The places on the page [units].
struct DotLayout {
  static constexpr double margin = 16, key = 20, foot = 58, min_panel = 90;
  double top = margin, row = 34, bottom = 0, page_height = 0;

  DotLayout(const DotChart& chart, const PageSize& size) {
    top += key * static_cast<double>(chart.series.size());
    const auto rows = static_cast<double>(chart.names.size());
    row = std::max(row, 12.0 * static_cast<double>(chart.series.size() + 1));
    if (size.height > 0.0)
      row = (size.height - top - foot) / rows;
    if (row < 14.0)
      throw std::runtime_error(
          "the size leaves no room for the rows: choose a larger size");
    bottom = top + row * rows;
    page_height = bottom + foot;
  }
};

class DotDrawing : DotLayout {
 public:
  DotDrawing(cairo_t* cairo, const DotChart& chart, const DotLayout& layout,
             const PageSize& size)
      : DotLayout(layout), pen_(cairo, size), cairo_(cairo), chart_(chart),
        low_(chart.low), high_(chart.high), end_(size.width - margin) {
    double widest = 0.0;
    for (const std::string& name : chart.names)
      widest = std::max(widest, pen_.width(name, 14));
    left_ = margin + std::min(widest, 0.5 * size.width) + gap;
    if (end_ - left_ < min_panel)
      throw std::runtime_error(
          "the size leaves no room for the values: choose a larger size");
    for (const DotSeries& one : chart.series)
      for (const auto* values : {&one.value, &one.low, &one.high})
        for (const double value : *values)
          if (std::isfinite(value)) {
            low_ = std::min(low_, value);
            high_ = std::max(high_, value);
          }
    const double wider = 0.03 * (high_ - low_);
    low_ -= wider, high_ += wider;
  }

  void draw() {
    pen_.clear();
    axis();
    for (std::size_t i = 0; i < chart_.names.size(); ++i)
      pen_.text(chart_.names[i], left_ - gap, row_middle(i), 14, ink, 1, 0.5,
                left_ - gap - margin);
    for (std::size_t s = 0; s < chart_.series.size(); ++s) {
      points_of(s);
      const double y = margin + key * (static_cast<double>(s) + 0.5) - 6;
      interval(s, margin, margin + 26, y);
      point(s, margin + 13, y);
      pen_.text(chart_.series[s].legend, margin + 34, y, 13, ink, 0, 0.5,
                end_ - margin - 34);
    }
    cairo_rectangle(cairo_, left_, top, end_ - left_, bottom - top);
    pen_.stroke(1.0, ink);
  }

 private:
  static constexpr double gap = 9;

  double page_x(double value) const {
    return left_ + (value - low_) / (high_ - low_) * (end_ - left_);
  }
  double row_middle(std::size_t i) const {
    return top + row * (static_cast<double>(i) + 0.5);
  }

  void axis() {
    for (std::size_t i = 1; i < chart_.names.size(); ++i) {
      const double y = top + row * static_cast<double>(i);
      pen_.line(left_, y, end_, y, 1.0, rule);
    }
    const TickLabels along = label_ticks(
        low_, high_, std::clamp(static_cast<int>((end_ - left_) / 60), 2, 6));
    for (std::size_t i = 0; i < along.ticks.size(); ++i) {
      const double x = page_x(along.ticks[i]);
      pen_.line(x, top, x, bottom, 1.0, along.ticks[i] == 0.0 ? muted : rule);
      pen_.text(along.labels[i], x, bottom + 9, 14, ink, 0.5, 0);
    }
    pen_.text(along.axis_title(chart_.x_label), (left_ + end_) / 2, bottom + 33, 15,
              ink, 0.5, 0);
  }

  void points_of(std::size_t s) {
    const DotSeries& one = chart_.series[s];
    const double step = row / static_cast<double>(chart_.series.size() + 1);
    for (std::size_t i = 0; i < chart_.names.size(); ++i) {
      const double y =
          top + row * static_cast<double>(i) + step * static_cast<double>(s + 1);
      if (std::isfinite(one.low[i]) && std::isfinite(one.high[i]))
        interval(s, page_x(one.low[i]), page_x(one.high[i]), y);
      if (std::isfinite(one.value[i]))
        point(s, page_x(one.value[i]), y);
    }
  }

  void interval(std::size_t s, double from, double to, double y) {
    constexpr double cap = 4.0;
    for (const double end : {from, to}) {
      cairo_move_to(cairo_, end, y - cap);
      cairo_line_to(cairo_, end, y + cap);
    }
    pen_.line(from, y, to, y, 1.8, line_colour(s));
  }

  /// Disc, square or diamond, so that the series differ without colours.
  void point(std::size_t s, double x, double y) {
    constexpr double radius = 4.6;
    const std::size_t shape = s % 3;
    if (shape == 0)
      cairo_arc(cairo_, x, y, radius, 0, 2 * std::numbers::pi);
    else if (shape == 1)
      cairo_rectangle(cairo_, x - radius, y - radius, 2 * radius, 2 * radius);
    else
      for (const auto& [dx, dy] : {std::pair{0, -1}, {1, 0}, {0, 1}, {-1, 0}})
        cairo_line_to(cairo_, x + 1.4 * radius * dx, y + 1.4 * radius * dy);
    pen_.fill(line_colour(s));
  }

  Pen pen_;
  cairo_t* cairo_;
  const DotChart& chart_;
  double low_, high_, left_ = 0, end_;
};

}  // namespace

std::string chart_svg(const DotChart& chart, const PageSize& page) {
  const DotLayout layout(chart, page);
  return svg_page(page, layout.page_height, [&](cairo_t* cairo) {
    DotDrawing(cairo, chart, layout, page).draw();
  });
}

void draw_chart(const std::string& path, const DotChart& chart, const PageSize& page) {
  const DotLayout layout(chart, page);
  write_page(path, page, layout.page_height,
             [&](cairo_t* cairo) { DotDrawing(cairo, chart, layout, page).draw(); });
}

}  // namespace blocks::draw
