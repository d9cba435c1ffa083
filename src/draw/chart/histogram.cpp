#include "draw/chart/histogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/axes.hpp"
#include "draw/number_text.hpp"

namespace blocks::draw {
namespace {

constexpr Colour bar_colour{0.47, 0.55, 0.62}, bar_grid{0.9, 0.9, 0.9};
constexpr double max_whole = 12;  ///< larger whole numbers share the last bar

/// Bars with equal widths on the axis, which has values or their logarithms.
struct Bars {
  double low = 0.0, width = 1.0;
  std::vector<double> counts;
  double high() const { return low + width * static_cast<double>(counts.size()); }
};

/// Returns a round width of bars in decades, for about 2 cbrt(n) bars (Rice's rule).
double decades_of_bar(double span, std::size_t n) {
  const double wanted =
      std::clamp(std::ceil(2.0 * std::cbrt(static_cast<double>(n))), 6.0, 24.0);
  for (const double width : {0.05, 0.1, 0.2, 0.5, 1.0})
    if (span / width <= wanted)
      return width;
  return std::ceil(span / wanted);
}

Bars bars_of(const Histogram& histogram) {
  std::vector<double> values = histogram.values;
  for (double& value : values)
    value = histogram.whole ? std::min(value, max_whole) : std::log10(value);
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  Bars bars;
  if (histogram.whole) {
    bars.low = *min - 0.5;
  } else {
    bars.width = decades_of_bar(*max - *min, values.size());
    constexpr double rounding = 1e-9;  // of a logarithm at the end of a bar
    bars.low = bars.width * std::floor(*min / bars.width + rounding);
  }
  const auto bar_at = [&](double value) {
    constexpr double rounding = 1e-9;
    return static_cast<std::size_t>(
        std::max(0.0, std::floor((value - bars.low) / bars.width + rounding)));
  };
  bars.counts.resize(bar_at(*max) + 1);
  for (const double value : values)
    ++bars.counts[bar_at(value)];
  return bars;
}

/// Returns "0.5", "200", "10⁶" or "3 × 10⁻⁵".
std::string power_text(double value) {
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  if (power < 5 && power > -4)
    return fmt::format("{:g}", value);
  const double digit = value / std::pow(10.0, power);
  return (digit < 1.01 ? "" : fmt::format("{:.3g} × ", digit)) + "10" +
         superscript(power);
}

/// Returns about five round values between the ends of a logarithmic axis.
std::vector<double> log_ticks(double low, double high) {
  if (high - low < 1.0)
    return nice_ticks(std::pow(10.0, low), std::pow(10.0, high), 5);
  const int every = static_cast<int>((high - low) / 6.0) + 1;  // decades
  std::vector<double> digits = {1.0};
  if (high - low < 3.0)
    digits = high - low < 2.0 ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0, 3.0};
  std::vector<double> found;
  for (double power = std::floor(low); power <= high; power += every)
    for (const double digit : digits) {
      constexpr double rounding = 1e-9;
      const double at = power + std::log10(digit);
      if (at >= low - rounding && at <= high + rounding)
        found.push_back(digit * std::pow(10.0, power));
    }
  return found;
}

class HistogramDrawing {
 public:
  HistogramDrawing(Pen& pen, const HistogramPlace& place, const Histogram& histogram)
      : pen_(pen), cairo_(pen.cairo()), place_(place), histogram_(histogram),
        bars_(bars_of(histogram)) {
    const double margin = 0.5 * bars_.width;
    low_ = bars_.low - margin;
    high_ = bars_.high() + margin;
    max_ = 1.06 * *std::max_element(bars_.counts.begin(), bars_.counts.end());
  }

  void draw() {
    count_axis();
    bars();
    cairo_rectangle(cairo_, place_.left, place_.top, place_.width, place_.height);
    pen_.stroke(1.0, ink);
    value_axis();
    pen_.text(histogram_.note, place_.left + place_.width, place_.top - 8, 13, muted, 1,
              1, place_.width);
  }

 private:
  double page_x(double value) const {
    return place_.left + place_.width * (value - low_) / (high_ - low_);
  }
  double page_y(double count) const {
    return place_.top + place_.height * (1.0 - count / max_);
  }

  void count_axis() {
    const int wanted =
        std::clamp(static_cast<int>(std::min(place_.height / 42, max_)), 1, 5);
    const TickLabels marked = label_ticks(0.0, max_, wanted);
    for (std::size_t i = 0; i < marked.ticks.size(); ++i) {
      const double y = page_y(marked.ticks[i]);
      pen_.line(place_.left, y, place_.left + place_.width, y, 0.8, bar_grid);
      pen_.text(marked.labels[i], place_.left - 8, y, 13, ink, 1, 0.5);
    }
    pen_.text(marked.titled(histogram_.counted), place_.left, place_.top - 8, 13, ink,
              0, 1);
  }

  void bars() {
    for (std::size_t i = 0; i < bars_.counts.size(); ++i) {
      const double from = page_x(bars_.low + bars_.width * static_cast<double>(i));
      const double to = page_x(bars_.low + bars_.width * static_cast<double>(i + 1));
      const double gap = histogram_.whole ? 0.14 * (to - from) : 0.0;
      if (bars_.counts[i] == 0.0)
        continue;
      const double y = page_y(bars_.counts[i]);
      cairo_rectangle(cairo_, from + gap, y, to - from - 2 * gap,
                      place_.top + place_.height - y);
      pen_.fill_and_stroke(bar_colour, 0.8, white);
    }
  }

  void tick(double at, const std::string& label) {
    const double x = page_x(at), bottom = place_.top + place_.height;
    pen_.line(x, bottom, x, bottom + 5, 1.0, ink);
    const double half = 0.5 * pen_.width(label, 13);
    if (x - half < label_end_)
      return;
    pen_.text(label, x, bottom + 10, 13, ink, 0.5, 0);
    label_end_ = x + half + 6;
  }

  void value_axis() {
    if (histogram_.whole)
      for (double value = std::ceil(low_); value <= high_; ++value) {
        if (value < bars_.low || value > bars_.high())
          continue;
        tick(value, fmt::format("{:g}{}", value, value == max_whole ? "+" : ""));
      }
    else
      for (const double value : log_ticks(low_, high_))
        tick(std::log10(value), power_text(value));
    pen_.text(histogram_.label, place_.left + 0.5 * place_.width,
              place_.top + place_.height + 33, 14, ink, 0.5, 0, place_.width);
  }

  Pen& pen_;
  cairo_t* cairo_;
  const HistogramPlace& place_;
  const Histogram& histogram_;
  const Bars bars_;
  double low_ = 0.0, high_ = 1.0, max_ = 1.0;  ///< ends of the axes
  double label_end_ = -1e300;                  ///< of the last label of the x axis
};

}  // namespace

void draw_histogram(Pen& pen, const HistogramPlace& place, const Histogram& histogram) {
  HistogramDrawing(pen, place, histogram).draw();
}

}  // namespace blocks::draw
