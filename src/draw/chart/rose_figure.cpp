#include "draw/chart/rose_figure.hpp"

#include <algorithm>
#include <stdexcept>

#include "draw/page_file.hpp"

namespace blocks::draw {

RoseLayout::RoseLayout(double legend_high, std::size_t histograms, const PageSize& page,
                       bool titled)
    : plots(histograms) {
  constexpr double narrow = 620, edge = 22;
  constexpr double usual_radius = 262, min_radius = 60;
  constexpr double usual_plot = 190, min_plot = 50;
  is_narrow = page.width < narrow;
  left = page.printed ? 14 : edge;
  title = page.printed ? 24 : 34, subtitle = page.printed ? 44 : 62;
  if (!titled)
    subtitle = title;
  const double top = subtitle + (page.printed ? 8 : 16);
  const double right = page.width - left;
  const auto columns = static_cast<double>(is_narrow ? 1 : histograms);
  const double rows = is_narrow ? static_cast<double>(histograms) : 1;
  const double legend_width = is_narrow ? right - left : std::min(330.0, 0.4 * right);
  double radius =
      0.5 * (right - left - (is_narrow ? 0.0 : legend_width + 30)) - RosePlace::beside;
  radius = std::min(radius, usual_radius);
  double plot = is_narrow ? 120 : usual_plot;
  const double around_plot = HistogramPlace::above + HistogramPlace::below;
  const auto rose_height = [&] {
    const double disc = RosePlace::above + radius + RosePlace::below;
    return is_narrow ? disc + legend_high + 14 : std::max(disc, legend_high + 40);
  };
  const auto needed = [&] { return top + rose_height() + rows * (plot + around_plot); };
  height = page.height > 0.0 ? page.height : needed();
  if (page.height > 0.0) {
    const double spare = page.height - needed();  // shared by disc and plots
    radius = std::min(radius, radius + std::min(0.0, 0.5 * spare));
    plot += (page.height - needed()) / rows;
  }
  if (radius < min_radius || plot < min_plot)
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
  const double wide = (right - left - (columns - 1) * gap) / columns;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const auto k = static_cast<double>(i);
    plots[i] = {left + HistogramPlace::beside + (is_narrow ? 0 : k * (wide + gap)),
                first + (is_narrow ? k * (plot + around_plot) : 0),
                wide - HistogramPlace::beside, plot};
  }
}

void draw_rose_figure(Pen& pen, const RoseLayout& layout, const PageSize& page,
                      const RoseFigure& figure) {
  pen.clear();
  const double width = page.width - 2 * layout.left;
  pen.text(figure.heading, layout.left, layout.title, 21, ink, 0, 1, width);
  pen.text(figure.subtitle, layout.left, layout.subtitle, page.printed ? 12.5 : 15,
           muted, 0, 1, width);
  draw_rose(pen, layout.rose, figure.directions);
  draw_rose_legend(pen, layout.legend_left, layout.legend_top, layout.legend_wide,
                   figure.directions, figure.name_of);
  for (std::size_t i = 0; i < figure.histograms.size(); ++i)
    draw_histogram(pen, layout.plots[figure.first_plot + i], figure.histograms[i]);
}

void draw_rose_figure(const std::string& path, const PageSize& page,
                      const RoseFigure& figure) {
  const RoseLayout layout(rose_legend_height(figure.directions),
                          figure.first_plot + figure.histograms.size(), page,
                          !figure.heading.empty());
  write_page(path, page, layout.height, [&](cairo_t* cairo) {
    Pen pen(cairo, page);
    draw_rose_figure(pen, layout, page, figure);
  });
}

}  // namespace blocks::draw
