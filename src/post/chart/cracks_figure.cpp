#include "post/chart/cracks_figure.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "draw/chart/rose_figure.hpp"
#include "draw/number_text.hpp"
#include "text/counted.hpp"

namespace blocks::post {

using namespace draw;

namespace {

constexpr int by_stress = 1, by_points = 2;  // colours of the rose

Directions directions_of(const std::vector<Crack>& cracks) {
  std::vector<DirectedLength> cuts;
  for (const Crack& crack : cracks)
    cuts.push_back(
        {crack.by_points ? by_points : by_stress, crack.angle(), crack.length()});
  return direction_statistics(cuts);
}

/// A histogram of lengths or areas, with their median.
Histogram crack_histogram(const std::string& name, const char* counted,
                          const Dimension& dimension, const FigureOptions& options,
                          std::vector<double> values) {
  const std::string unit = unit_text(dimension, options.units);
  Histogram histogram{
      options.with_unit(name, dimension), std::move(values), false, {}, counted};
  histogram.note = fmt::format("median {:.3g} {}", median_of(histogram.values), unit);
  return histogram;
}

std::vector<Histogram> crack_histograms(const std::vector<Crack>& cracks,
                                        const FigureOptions& options) {
  std::vector<double> lengths, areas;
  for (const Crack& crack : cracks) {
    lengths.push_back(crack.length());
    areas.push_back(crack.child_area);
  }
  return {crack_histogram("length", "cracks", {1, 0, 0, "m", ""}, options,
                          std::move(lengths)),
          crack_histogram("area of the block that split off", "blocks",
                          {2, 0, 0, "m²", ""}, options, std::move(areas))};
}

/// Returns "12 cracks, at t = 0.1 s to 0.5 s".
std::string crack_period(const std::vector<Crack>& cracks,
                         const std::optional<Units>& units) {
  const double first = cracks.front().time, last = cracks.back().time;
  return counted(cracks.size(), "crack") + "    " +
         time_text(first, std::nullopt, units) +
         (last > first ? " to " + time_text(last, std::nullopt, units) : "");
}

}  // namespace

void draw_cracks_figure(const std::string& path, const std::vector<Crack>& cracks,
                        const std::string& title, const FigureOptions& options) {
  if (cracks.empty())
    throw std::runtime_error("there is no crack to draw");
  draw_rose_figure(path, options.page,
                   {options.title.value_or(title.empty() ? "BLOCKS" : title),
                    options.subtitle.empty() ? crack_period(cracks, options.units)
                                             : options.subtitle,
                    directions_of(cracks),
                    [](int group) {
                      return group == by_points ? "cracks by point loads"
                                                : "cracks by stress";
                    },
                    crack_histograms(cracks, options)});
}

}  // namespace blocks::post
