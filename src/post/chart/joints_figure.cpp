#include "post/chart/joints_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "draw/chart/histogram.hpp"
#include "draw/chart/rose.hpp"
#include "draw/chart/rose_layout.hpp"
#include "draw/number_text.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "post/chart/joint_statistics.hpp"
#include "post/figure/figure_legend.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using Histograms = std::array<Histogram, 3>;

Histograms histograms_of(const JointStatistics& joints, const FigureOptions& options) {
  constexpr Dimension area{2, 0, 0, "m²", ""};
  const std::string unit = unit_text(area, options.units);
  const double mean = std::accumulate(joints.sides.begin(), joints.sides.end(), 0.0) /
                      static_cast<double>(joints.sides.size());
  return {Histogram{with_unit("area", area, options), joints.area, false,
                    fmt::format("median {:.3g} {}", median_of(joints.area), unit)},
          {"aspect ratio", joints.aspect, false,
           fmt::format("median {:.3g}", median_of(joints.aspect))},
          {"number of sides", joints.sides, true, fmt::format("mean {:.3g}", mean)}};
}

}  // namespace

void draw_joints_figure(const std::string& path, const Frame& frame,
                        const std::string& title, const FigureOptions& options) {
  const JointStatistics joints = joint_statistics(frame);
  const Histograms histograms = histograms_of(joints, options);
  const std::string heading = options.title.value_or(title.empty() ? "BLOCKS" : title);
  const RoseLayout layout(rose_legend_height(joints.directions), histograms.size(),
                          options.page, !heading.empty());
  const std::string subtitle =
      !options.subtitle.empty()
          ? options.subtitle
          : fmt::format("{}    {}    {}",
                        time_text(frame.time, std::nullopt, options.units),
                        counted(joints.area.size(), "block") + " at joints",
                        counted(joints.directions.groups.size(), "joint id"));
  write_page(path, options.page, layout.height, [&](cairo_t* cairo) {
    Pen pen(cairo, options.page);
    draw_heading(pen, layout, options.page, heading, subtitle);
    draw_rose(pen, layout.rose, joints.directions);
    draw_rose_legend(pen, layout.legend_left, layout.legend_top, layout.legend_wide,
                     joints.directions,
                     [](int id) { return fmt::format("joint {}", id); });
    for (std::size_t i = 0; i < histograms.size(); ++i)
      draw_histogram(pen, layout.plots[i], histograms[i]);
  });
}

}  // namespace blocks::post
