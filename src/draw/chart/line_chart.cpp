#include "draw/chart/line_chart.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "draw/axes.hpp"
#include "draw/chart/chart_layout.hpp"
#include "draw/line_colours.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "draw/value_range.hpp"

namespace blocks::draw {
namespace {

constexpr Colour grid{0.9, 0.9, 0.9};
constexpr double band_opacity = 0.28, bar_opacity = 0.72;
constexpr double tick_size = 14;  ///< letters of the tick labels [units]
constexpr double tick_gap = 9;    ///< from a tick label to the y axis [units]

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double value) {
    if (!std::isfinite(value))
      return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return !(low <= high); }
  /// Adds a margin: a line on the frame would be hidden, and a constant has no range.
  Range widened(double part) const {
    const double margin = high > low    ? part * (high - low)
                          : high == 0.0 ? 1.0
                                        : 0.1 * std::abs(high);
    return {low - margin, high + margin};
  }
};

class ChartDrawing : ChartLayout {
  using Form = ChartLine::Form;

 public:
  ChartDrawing(cairo_t* cairo, const Chart& chart, const ChartLayout& layout,
               const PageSize& size)
      : ChartLayout(layout), pen_(cairo, size), cairo_(cairo), chart_(chart) {
    bool wide = false;
    for (const ChartPanel& one : chart.panels)
      for (const ChartLine& line : one.lines) {
        const double half = line.form == Form::bars ? 0.5 * line.bar : 0.0;
        wide = wide || line.form == Form::intervals || line.form == Form::bars;
        for (std::size_t i = 0; i < line.x.size(); ++i)
          if (std::isfinite(line.y[i])) {
            x_.include(line.x[i] - half);
            x_.include(line.x[i] + half);
          }
      }
    if (x_.empty())
      throw std::runtime_error("there is nothing to draw: no curve has a number");
    x_ = wide ? x_.widened(0.04) : x_.high > x_.low ? x_ : x_.widened(0.0);
    make_space_for_ticks(size.printed);
  }

  void draw() {
    pen_.clear();
    pen_.text(chart_.title, left, title, 21, ink, 0, 1, page - left - 16);
    pen_.text(chart_.subtitle, left, subtitle, keys_above ? 12.5 : 15, muted, 0, 1,
              page - left - 16);
    double top = head;
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
      top += keys(chart_.panels[i]);
      draw_panel(chart_.panels[i], top, i + 1 == chart_.panels.size());
      top += panel + between;
    }
  }

 private:
  double page_x(double x) const {
    return left + (x - x_.low) / (x_.high - x_.low) * (page - left - right);
  }

  /// Moves the left edge of the panels if tick labels would reach the label of the y
  /// axis, and in print also if they leave a gap. The height of the panels remains.
  void make_space_for_ticks(bool printed) {
    const double label_end = label_x_ + 15;  // its letters reach 10 to the right
    if (printed)
      left = label_end;
    for (const ChartPanel& one : chart_.panels)
      for (const std::string& label : ticks_of(one, range_of(one)).labels)
        left = std::max(left, label_end + pen_.width(label, tick_size) + tick_gap);
  }

  /// Returns the ticks of the y axis.
  TickLabels ticks_of(const ChartPanel& one, const ValueRange& y) const {
    int count = std::clamp(static_cast<int>(panel / 42), 3, 6);
    if (has_bars(one))  // bars count, so the ticks are whole numbers
      count = std::clamp(static_cast<int>(y.high), 1, count);
    return y.ticks(count);
  }

  void draw_panel(const ChartPanel& one, double top, bool last) {
    const ValueRange y = range_of(one);
    const double bottom = top + panel, end = page - right;
    const auto page_y = [&](double value) { return bottom - y.place(value) * panel; };
    const TickLabels along = label_ticks(
        x_.low, x_.high, std::clamp(static_cast<int>((end - left) / 80), 3, 8));
    for (std::size_t i = 0; i < along.ticks.size(); ++i) {
      const double x = page_x(along.ticks[i]);
      pen_.line(x, top, x, bottom, 1.0, grid);
      if (last)
        pen_.text(along.labels[i], x, bottom + 11, 14, ink, 0.5, 0);
    }
    const TickLabels up = ticks_of(one, y);
    for (std::size_t i = 0; i < up.ticks.size(); ++i) {
      const double at = page_y(up.ticks[i]);
      pen_.line(left, at, end, at, 1.0, up.ticks[i] == 0.0 ? muted : grid);
      pen_.text(up.labels[i], left - tick_gap, at, tick_size, ink, 1, 0.5);
    }
    cairo_save(cairo_);
    cairo_rectangle(cairo_, left, top, end - left, panel);
    cairo_clip(cairo_);
    for (std::size_t i = 0; i < one.lines.size(); ++i)
      if (one.lines[i].form == Form::curve)
        draw_band(one.lines[i], i, page_y);
      else if (one.lines[i].form == Form::bars)
        draw_bars(one.lines[i], i, page_y);
    for (std::size_t i = 0; i < one.lines.size(); ++i)
      if (one.lines[i].form == Form::curve)
        draw_line(one.lines[i], i, page_y);
      else if (one.lines[i].form == Form::intervals)
        draw_intervals(one.lines[i], i, page_y);
      else if (one.lines[i].form == Form::mark)
        draw_mark(one.lines[i], i, top, bottom);
    cairo_restore(cairo_);
    cairo_rectangle(cairo_, left, top, end - left, panel);
    pen_.stroke(1.0, ink);
    pen_.upright(up.axis_title(one.y_label), label_x_, top + panel / 2, 15, ink, panel);
    if (last) {
      pen_.text(along.axis_title(chart_.x_label), (left + end) / 2, bottom + 38, 15,
                ink, 0.5, 0);
    }
    if (keys_above)
      legend_above(one, top - keys(one));
    else
      legend(one, end + 18, top + 6);
  }

  static bool has_bars(const ChartPanel& one) {
    return std::any_of(one.lines.begin(), one.lines.end(),
                       [](const ChartLine& line) { return line.form == Form::bars; });
  }

  /// Returns the values that a panel shows. Bars begin at 0.
  static ValueRange range_of(const ChartPanel& one) {
    Range y, positive;
    const bool bars = has_bars(one);
    for (const ChartLine& line : one.lines) {
      if (line.form == Form::mark)
        continue;
      for (const auto* values : {&line.y, &line.low, &line.high})
        for (const double value : *values) {
          y.include(value);
          positive.include(value > 0.0 ? value : std::nan(""));
        }
    }
    constexpr int max_decades = 16;  // doubles resolve no more
    if (one.logarithmic && !positive.empty())
      return ValueRange::of_decades(positive.low, positive.high, max_decades);
    if (bars)
      y.include(0.0);
    if (y.empty())
      return {0, 1};
    const Range wide = y.widened(0.06);
    return {bars && y.low == 0.0 ? 0.0 : wide.low, wide.high};
  }

  /// Draws the current path as line i: lines of one colour differ in their dashes.
  void stroke(std::size_t i, ChartLine::Form form) {
    const std::size_t round = i / line_colours % 4;
    if (form == Form::mark)
      pen_.dashes({6, 4});
    else if (round == 1)
      pen_.dashes({9, 5});
    else if (round == 2)
      pen_.dashes({2, 4});
    else if (round == 3)
      pen_.dashes({10, 4, 2, 4});
    pen_.stroke(2.2, line_colour(i));
    pen_.dashes({});
  }

  /// Fills the space between both ends, from one point to the next.
  template <class PageY>
  void draw_band(const ChartLine& line, std::size_t i, const PageY& page_y) {
    pen_.colour(line_colour(i), band_opacity);
    for (std::size_t k = 1; k < line.low.size(); ++k) {
      const double from = page_x(line.x[k - 1]), to = page_x(line.x[k]);
      if (!std::isfinite(line.low[k - 1]) || !std::isfinite(line.low[k]))
        continue;
      cairo_move_to(cairo_, from, page_y(line.low[k - 1]));
      cairo_line_to(cairo_, to, page_y(line.low[k]));
      cairo_line_to(cairo_, to, page_y(line.high[k]));
      cairo_line_to(cairo_, from, page_y(line.high[k - 1]));
      cairo_close_path(cairo_);
    }
    cairo_fill(cairo_);
  }

  template <class PageY>
  void draw_bars(const ChartLine& line, std::size_t i, const PageY& page_y) {
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      if (!std::isfinite(line.y[k]) || line.y[k] == 0.0)
        continue;
      const double from = page_x(line.x[k] - 0.5 * line.bar),
                   to = page_x(line.x[k] + 0.5 * line.bar);
      cairo_rectangle(cairo_, from, page_y(line.y[k]), to - from,
                      page_y(0.0) - page_y(line.y[k]));
    }
    pen_.colour(line_colour(i), bar_opacity);
    cairo_fill_preserve(cairo_);
    pen_.stroke(1.0, white);
  }

  template <class PageY>
  void draw_intervals(const ChartLine& line, std::size_t i, const PageY& page_y) {
    for (std::size_t k = 0; k < line.x.size(); ++k)
      if (std::isfinite(line.y[k]))
        cairo_line_to(cairo_, page_x(line.x[k]), page_y(line.y[k]));
    pen_.stroke(1.4, line_colour(i), band_opacity);
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      if (!std::isfinite(line.y[k]))
        continue;
      const double x = page_x(line.x[k]);
      if (k < line.low.size() && std::isfinite(line.low[k]))
        error_bar(i, x, page_y(line.low[k]), page_y(line.high[k]));
      point(i, x, page_y(line.y[k]));
    }
  }

  /// Draws a bar between two heights [units], with caps.
  void error_bar(std::size_t i, double x, double low, double high) {
    constexpr double cap = 5.0;
    for (const double end : {low, high}) {
      cairo_move_to(cairo_, x - cap, end);
      cairo_line_to(cairo_, x + cap, end);
    }
    pen_.line(x, low, x, high, 1.8, line_colour(i));
  }

  void point(std::size_t i, double x, double y) {
    constexpr double radius = 4.2;
    cairo_arc(cairo_, x, y, radius, 0, 2 * std::numbers::pi);
    pen_.fill(line_colour(i));
  }

  void draw_mark(const ChartLine& line, std::size_t i, double top, double bottom) {
    for (const double x : line.x) {
      cairo_move_to(cairo_, page_x(x), top);
      cairo_line_to(cairo_, page_x(x), bottom);
    }
    stroke(i, line.form);
  }

  template <class PageY>
  void draw_line(const ChartLine& line, std::size_t i, const PageY& page_y) {
    for (std::size_t k = 0; k < line.x.size(); ++k)
      if (std::isfinite(line.x[k]) && std::isfinite(line.y[k]))
        cairo_line_to(cairo_, page_x(line.x[k]), page_y(line.y[k]));
      else
        cairo_new_sub_path(cairo_);
    stroke(i, line.form);
    if (line.x.size() > 60)
      return;
    for (std::size_t k = 0; k < line.x.size(); ++k)
      if (std::isfinite(line.x[k]) && std::isfinite(line.y[k])) {
        cairo_arc(cairo_, page_x(line.x[k]), page_y(line.y[k]), 3.2, 0,
                  2 * std::numbers::pi);
        cairo_fill(cairo_);
      }
  }

  /// Draws a piece of the line or band, centred at this height.
  void sample(const ChartKey& key, double x, double y) {
    constexpr double width = 26, height = 10;
    if (key.form == Form::intervals) {
      if (key.is_band)
        error_bar(key.line, x + width / 2, y - height / 2, y + height / 2);
      else
        point(key.line, x + width / 2, y);
      return;
    }
    if (key.is_band || key.form == Form::bars) {
      cairo_rectangle(cairo_, x, y - height / 2, width, height);
      pen_.fill(line_colour(key.line), key.is_band ? band_opacity : bar_opacity);
      return;
    }
    cairo_move_to(cairo_, x, y);
    cairo_line_to(cairo_, x + width, y);
    stroke(key.line, key.form);
  }

  void legend_above(const ChartPanel& one, double y) {
    const auto all = keys_of(one);
    // Long entries begin to the left of the panel.
    double widest = 0.0;
    for (const ChartKey& key : all)
      widest = std::max(widest, pen_.width(key.words, 13));
    const double x = std::clamp(page - right - 36 - widest, 14.0, left);
    for (std::size_t i = 0; i < std::min(all.size(), max_keys); ++i) {
      y += key_line;
      if (i + 1 == max_keys && all.size() > max_keys) {
        pen_.text(fmt::format("and {} more", all.size() - i), x, y - 10, 13, muted, 0,
                  0.5);
        return;
      }
      sample(all[i], x, y - 10);
      pen_.text(all[i].words, x + 34, y - 10, 13, ink, 0, 0.5, page - right - x - 34);
    }
  }

  /// Entries are closer together if there are many.
  void legend(const ChartPanel& one, double x, double y) {
    constexpr double tall = 24, low = 13;
    const auto all = keys_of(one);
    const auto n = static_cast<double>(all.size());
    const double step = std::clamp(panel / n, low, tall);
    const auto rows = static_cast<std::size_t>(panel / step);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i + 1 == rows && all.size() > rows) {
        pen_.text(fmt::format("and {} more", all.size() - i), x, y + step / 3, 11,
                  muted, 0, 0.5);
        return;
      }
      sample(all[i], x, y + step / 3);
      pen_.text(all[i].words, x + 34, y + step / 3, std::min(13.0, 0.85 * step), ink, 0,
                0.5, page - x - 44);
      y += step;
    }
  }

  Pen pen_;
  cairo_t* cairo_;
  const Chart& chart_;
  const double label_x_ = left > 100 ? 22 : 14;  ///< middle of the label of the y axis
  Range x_;
};

}  // namespace

std::string chart_svg(const Chart& chart, const PageSize& page) {
  const ChartLayout layout(chart, page);
  return svg_page(page, layout.page_height, [&](cairo_t* cairo) {
    ChartDrawing(cairo, chart, layout, page).draw();
  });
}

void draw_chart(const std::string& path, const Chart& chart, const PageSize& page) {
  const ChartLayout layout(chart, page);
  write_page(path, page, layout.page_height,
             [&](cairo_t* cairo) { ChartDrawing(cairo, chart, layout, page).draw(); });
}

}  // namespace blocks::draw
