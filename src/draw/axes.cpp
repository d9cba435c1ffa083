#include "draw/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/number_text.hpp"

namespace blocks::draw {

Axes::Axes(const Eigen::Vector4d& shown, double at_left, double at_top,
           double plot_width)
    : xmin(shown[0]), xmax(shown[1]), ymin(shown[2]), ymax(shown[3]), left(at_left),
      top(at_top), width(plot_width) {
  const double shape = std::clamp((ymax - ymin) / (xmax - xmin), 0.15, 1.4);
  height = width * shape;
  const double missing = shape * (xmax - xmin) - (ymax - ymin);
  if (missing > 0.0) {
    ymin -= 0.5 * missing;
    ymax += 0.5 * missing;
  } else {
    xmin += 0.5 * missing / shape;
    xmax -= 0.5 * missing / shape;
  }
}

std::vector<double> nice_ticks(double lower, double upper, int count) {
  std::vector<double> ticks;
  const double span = upper - lower;
  if (!(span > 0.0) || !std::isfinite(span))
    return ticks;
  const double raw = span / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  const double digit = raw / power;
  const double step = power * (digit < 1.5   ? 1
                               : digit < 3.5 ? 2
                               : digit < 7.5 ? 5
                                             : 10);
  if (std::max(std::abs(lower), std::abs(upper)) > 1e15 * step)
    return ticks;  // doubles are too coarse for the ticks
  for (double k = std::ceil(lower / step - 1e-9); k * step <= upper + 1e-9 * span; ++k)
    ticks.push_back(k * step == 0.0 ? 0.0 : k * step);
  return ticks;
}

namespace {

/// Returns the number between two ticks with the fewest digits; of several, the lowest.
double roundest(double first, double last, double step) {
  const double slack = 1e-6 * step;
  for (double power = std::ceil(std::log10(std::max(std::abs(first), std::abs(last))));;
       --power) {
    const double unit = std::pow(10.0, power);
    const double found = std::ceil((first - slack) / unit) * unit;
    if (found <= last + slack || unit < step)
      return found;
  }
}

std::size_t longest_label(const std::vector<std::string>& labels) {
  std::size_t max = 0;
  for (const std::string& label : labels)
    max = std::max(max, label.size());
  return max;
}

}  // namespace

std::string TickLabels::titled(const std::string& name) const {
  if (power == 0)
    return name;
  const std::string factor = "10" + superscript(power);
  const auto bracket = name.rfind('[');
  return bracket == std::string::npos
             ? name + " [" + factor + "]"
             : name.substr(0, bracket + 1) + factor + " " + name.substr(bracket + 1);
}

std::string TickLabels::axis_title(const std::string& name) const {
  if (offset.empty())
    return titled(name);
  const std::string change = (offset[0] == '-' ? " + " : " − ") + offset.substr(1);
  const auto bracket = name.rfind(" [");
  return bracket == std::string::npos
             ? name + change
             : name.substr(0, bracket) + change + name.substr(bracket);
}

TickLabels label_ticks(double lower, double upper, int count, Offset kind) {
  TickLabels result{nice_ticks(lower, upper, count), {}, {}};
  const std::vector<double>& ticks = result.ticks;
  if (ticks.empty())
    return result;
  const double span = ticks.back() - ticks.front();
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : upper - lower;
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  double offset = 0.0;
  const bool is_place =
      kind == Offset::of_large_numbers && largest >= 1e4 && span < 0.1 * largest;
  if (span > 0.0 && (is_place || largest >= 1e5 * step))
    offset = roundest(ticks.front(), ticks.back(), step);
  if (offset != 0.0)
    result.offset = fmt::format("{:+.15g}", offset);
  std::string decimals = "{:g}";
  if (offset != 0.0 && step < 0.9e-4)  // avoids -5e-05 next to -0.0001
    decimals = fmt::format("{{:.{}f}}", -std::floor(std::log10(step) + 1e-3));
  const auto labels = [&](int power) {
    std::vector<std::string> texts;
    const double counted = std::pow(10.0, -power);
    for (const double tick : ticks) {
      const double rest = tick - offset;
      // The difference carries the rounding error of the tick; round it off.
      const double unit = std::pow(10.0, std::floor(std::log10(step) + 1e-3));
      const double round = offset == 0.0 ? rest : std::round(rest / unit) * unit;
      texts.push_back(
          round == 0.0 ? "0" : fmt::format(fmt::runtime(decimals), round * counted));
    }
    return texts;
  };
  result.labels = labels(0);
  if (offset != 0.0 || !(largest > 0.0))
    return result;
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  std::vector<std::string> scaled = labels(power);
  // Wide labels take their space from the picture.
  constexpr std::size_t wide = 4;
  const std::size_t plain = longest_label(result.labels);
  if (largest >= 1e5 || largest < 1e-3 ||
      (plain > wide && longest_label(scaled) < plain)) {
    result.power = power;
    result.labels = std::move(scaled);
  }
  return result;
}

}  // namespace blocks::draw
