#include "post/joints_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "post/counted.hpp"
#include "post/figure_legend.hpp"
#include "post/joint_histograms.hpp"
#include "post/joint_rose.hpp"
#include "post/page_file.hpp"
#include "post/pen.hpp"

namespace blocks::post {
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

/// The places of rose, legend and histograms on the page [units].
class JointsLayout {
 public:
  JointsLayout(const JointStatistics& joints, const PageSize& page, bool titled) {
    constexpr double narrow = 620, edge = 22;
    constexpr double usual_radius = 262, least_radius = 60;
    constexpr double usual_plot = 190, least_plot = 50;
    is_narrow = page.width < narrow;
    left = page.printed ? 14 : edge;
    title = page.printed ? 24 : 34, subtitle = page.printed ? 44 : 62;
    if (!titled)
      subtitle = title;
    const double top = subtitle + (page.printed ? 8 : 16);
    const double right = page.width - left;
    const double legend_high = rose_legend_height(joints);
    const double rows = is_narrow ? 3 : 1;
    const double legend_width = is_narrow ? right - left : std::min(330.0, 0.4 * right);
    double radius = 0.5 * (right - left - (is_narrow ? 0.0 : legend_width + 30)) -
                    RosePlace::beside;
    radius = std::min(radius, usual_radius);
    double plot = is_narrow ? 120 : usual_plot;
    const double around_plot = HistogramPlace::above + HistogramPlace::below;
    const auto rose_height = [&] {
      const double disc = RosePlace::above + radius + RosePlace::below;
      return is_narrow ? disc + legend_high + 14 : std::max(disc, legend_high + 40);
    };
    const auto needed = [&] {
      return top + rose_height() + rows * (plot + around_plot);
    };
    height = page.height > 0.0 ? page.height : needed();
    if (page.height > 0.0) {
      const double spare = page.height - needed();  // shared by disc and plots
      radius = std::min(radius, radius + std::min(0.0, 0.5 * spare));
      plot += (page.height - needed()) / rows;
    }
    if (radius < least_radius || plot < least_plot)
      throw std::runtime_error(
          "the size leaves no room for the rose and the histograms: choose a larger "
          "size");
    const double all = 2 * (radius + RosePlace::beside);
    const double rose_left =
        is_narrow ? 0.5 * (page.width - all)
                  : left + 0.5 * std::max(0.0, right - left - all - legend_width - 30);
    rose = {rose_left + 0.5 * all, top + RosePlace::above + radius, radius};
    const double disc_bottom = rose.y + RosePlace::below;
    legend_left = is_narrow ? left : rose_left + all + 30;
    legend_wide = std::min(legend_width, right - legend_left);
    legend_top = is_narrow ? disc_bottom + 10
                           : std::max(top + 10, rose.y - 0.5 * (radius + legend_high));
    const double first = top + rose_height() + HistogramPlace::above;
    const double gap = 26;
    const double wide = is_narrow ? right - left : (right - left - 2 * gap) / 3;
    for (std::size_t i = 0; i < plots.size(); ++i) {
      const auto k = static_cast<double>(i);
      plots[i] = {left + HistogramPlace::beside + (is_narrow ? 0 : k * (wide + gap)),
                  first + (is_narrow ? k * (plot + around_plot) : 0),
                  wide - HistogramPlace::beside, plot};
    }
  }

  bool is_narrow = false;
  double left = 0, title = 0, subtitle = 0, height = 0;
  RosePlace rose{};
  double legend_left = 0, legend_top = 0, legend_wide = 0;
  std::array<HistogramPlace, 3> plots{};
};

}  // namespace

void draw_joints_figure(const std::string& path, const Frame& frame,
                        const std::string& title, const FigureOptions& options) {
  const JointStatistics joints = joint_statistics(frame);
  const Histograms histograms = histograms_of(joints, options);
  const std::string heading = options.title.value_or(title.empty() ? "BLOCKS" : title);
  const JointsLayout layout(joints, options.page, !heading.empty());
  const std::string subtitle =
      !options.subtitle.empty()
          ? options.subtitle
          : fmt::format("{}    {}    {}",
                        time_text(frame.time, std::nullopt, options.units),
                        counted(joints.area.size(), "block") + " at joints",
                        counted(joints.joints.size(), "joint id"));
  write_page(path, options.page, layout.height, [&](cairo_t* cairo) {
    Pen pen(cairo, options.page);
    pen.colour(paper);
    cairo_paint(cairo);
    const double room = options.page.width - 2 * layout.left;
    pen.text(heading, layout.left, layout.title, 21, ink, 0, 1, room);
    pen.text(subtitle, layout.left, layout.subtitle, options.page.printed ? 12.5 : 15,
             muted, 0, 1, room);
    draw_rose(pen, layout.rose, joints);
    draw_rose_legend(pen, layout.legend_left, layout.legend_top, layout.legend_wide,
                     joints);
    for (std::size_t i = 0; i < histograms.size(); ++i)
      draw_histogram(pen, layout.plots[i], histograms[i]);
  });
}

}  // namespace blocks::post
