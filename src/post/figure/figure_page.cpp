#include "post/figure/figure_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draw/number_text.hpp"
#include "post/figure/arrows.hpp"
#include "post/figure/figure_legend.hpp"
#include "post/figure/scene_drawing.hpp"
#include "post/read/frame_quantity.hpp"
#include "text/counted.hpp"

namespace blocks::post {

using namespace draw;

namespace {

constexpr double gap = 22, heading = 34;
constexpr double narrow = 620;  ///< a printed page has the legend below the pictures
constexpr double min_plot = 60;
constexpr Dimension length{1, 0, 0, "m", ""};

std::size_t present(const Frame& frame) {
  return static_cast<std::size_t>(frame.count_present());
}

/// Returns the largest local ratio and its block; empty if they are not known or 0.
std::string local_text(const Frame& now) {
  double max = 0.0;
  int block = 0;
  for (int b = 0; b < now.local_ratio.size(); ++b)
    if (now.local_ratio[b] > max)
      max = now.local_ratio[b], block = now.number[static_cast<std::size_t>(b)];
  return block > 0
             ? fmt::format("    largest local ratio {:.2g} in block {}", max, block)
             : "";
}

/// Returns the ratio of the unbalanced forces and the block with the largest one, if
/// the figure shows them.
std::string equilibrium_text(const Frame& now, const FigureOptions& options) {
  const QuantityKind* kind = quantities::find_quantity(options.colour);
  if (kind == nullptr || !quantities::is_of_equilibrium(kind->name))
    return "";
  double max = 0.0;
  int block = 0;
  for (int b = 0; b < now.unbalanced.size(); ++b)
    if (now.unbalanced[b] > max)  // false for removed blocks, which have no value
      max = now.unbalanced[b], block = now.number[static_cast<std::size_t>(b)];
  std::string text = fmt::format("    ratio {:.2g}", now.unbalanced_ratio);
  if (block > 0)
    text += fmt::format(", largest in block {}", block);
  return text + local_text(now);
}

/// Returns the number of cracks, unless there are none.
std::string cracks_text(const Frame& now) {
  return now.cracks > 0
             ? "    " + counted(static_cast<std::size_t>(now.cracks), "crack")
             : "";
}

/// True if a line below the title is drawn. A figure in print without a title has only
/// the line that is asked for, because its caption says the rest.
bool has_subtitle(const FigureOptions& options) {
  return !options.subtitle.empty() || !options.page.printed ||
         !options.title.has_value() || !options.title->empty();
}

FigureMargins margins_of(const FigureOptions& options, bool titled) {
  const PageSize& page = options.page;
  FigureMargins found;
  if (page.printed)
    found = {76, page.width < narrow ? 14.0 : 128.0, 24, 44, 54, 60};
  const double line = found.subtitle - found.title;
  if (!titled) {
    found.subtitle -= line;
    found.top -= line;
  }
  if (!has_subtitle(options))
    found.top -= line;
  return found;
}

/// The ticks of both axes.
struct Ticks {
  TickLabels along, up;
};

/// Returns the ticks. If the labels of one axis have an offset, so have those of the
/// other one, rather than a power of ten.
Ticks ticks_of(const Axes& axes) {
  const auto with = [&](Offset offset) {
    return Ticks{label_ticks(axes.xmin, axes.xmax,
                             std::max(3, static_cast<int>(axes.width / 97)), offset),
                 label_ticks(axes.ymin, axes.ymax,
                             std::max(2, static_cast<int>(axes.height / 70)), offset)};
  };
  Ticks found = with(Offset::of_long_labels);
  return found.along.offset.empty() == found.up.offset.empty()
             ? found
             : with(Offset::of_large_numbers);
}

}  // namespace

FigurePage::FigurePage(std::size_t count, std::string title, const FigureScales& scales,
                       const FigureOptions& options)
    : count_(count), title_(options.title.value_or(title.empty() ? "BLOCKS" : title)),
      scales_(scales), options_(options),
      margins_(margins_of(options, !title_.empty())),
      below_(options.page.printed && options.page.width < narrow) {
  lay_out();
  if (!options.page.printed)
    return;
  // Short numbers at the y axis leave more space for the picture.
  constexpr double letter = 9, min = 18;  // [units]
  std::size_t longest = 0;
  for (const std::string& label : ticks_of(axes(0)).up.labels)
    longest = std::max(longest, label.size());
  const double space = std::clamp(letter * static_cast<double>(longest), min, numbers_);
  margins_.left -= numbers_ - space;
  numbers_ = space;
  lay_out();
}

void FigurePage::lay_out() {
  const FigureOptions& options = options_;
  const std::size_t count = count_;
  const double page = options.page.width, fixed_height = options.page.height;
  const double left = margins_.left, right = margins_.right, top = margins_.top;
  const double foot =
      margins_.foot +
      (below_ ? legend_height_below(scales_, options, page - left - right) + 8 : 0.0);
  const double shape = [&] {
    const Axes one(scales_.view, 0, 0, 1);
    return one.height;
  }();
  double best = 1e300;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    if (options.columns > 0 &&
        columns != std::min(static_cast<std::size_t>(options.columns), count))
      continue;
    const auto across = static_cast<double>(columns);
    const auto rows = std::ceil(static_cast<double>(count) / across);
    const double above = count > 1 ? heading : 0;
    double width = (page - left - right - (across - 1) * gap) / across;
    if (fixed_height > 0.0)
      width = std::min(width, ((fixed_height - top - foot) / rows - above) / shape);
    const double needed =
        top + foot +
        std::max(rows * (width * shape + above),
                 below_ ? 0.0 : legend_height(scales_, options) - 0.5 * foot);
    const double height = fixed_height > 0.0 ? fixed_height : needed;
    // Choose the page closest to a landscape sheet, with few empty cells; on a page of
    // fixed height choose the largest pictures.
    const double empty = across * rows - static_cast<double>(count);
    const double far = fixed_height > 0.0
                           ? 1.0 / std::max(width, 1e-9)
                           : std::abs(std::log(height / (0.75 * page))) + 0.2 * empty;
    if (fixed_height > 0.0 && needed > height * (1.0 + 1e-9))
      continue;  // the legend is too high
    if (far >= best)
      continue;
    best = far;
    columns_ = columns;
    width_ = width;
    height_ = height;
  }
  if (width_ < min_plot)
    throw std::runtime_error(
        "the size leaves no room for the picture beside its numbers and legend: choose "
        "a larger size, or fewer times on the sheet");
}

Axes FigurePage::axes(std::size_t i) const {
  const std::size_t whole_rows = i / columns_;
  const auto column = static_cast<double>(i % columns_);
  const auto row = static_cast<double>(whole_rows);
  Axes result(scales_.view, margins_.left + column * (width_ + gap), margins_.top,
              width_);
  if (count_ > 1)
    result.top += heading + row * (result.height + heading);
  return result;
}

void FigurePage::begin(Pen& pen) const {
  pen.clear();
  pen.text(title_, margins_.left, margins_.title, 21, ink, 0, 1,
           options_.page.width - margins_.left - 14);
}

void FigurePage::picture(Pen& pen, std::size_t i, const Picture& picture) const {
  const Axes here = axes(i);
  draw_scene(pen, here, picture, scales_, options_);
  rulers(pen, here, i + columns_ >= count_, i % columns_ == 0);
  const auto& requested = options_.requested_times;
  const bool is_requested = i < requested.size() && !options_.page.printed;
  const std::string at = time_text(
      picture.now.time, is_requested ? std::optional(requested[i]) : std::nullopt,
      options_.units);
  if (count_ > 1)
    pen.text(at, here.left, here.top - 9, 15, muted, 0, 1);
  else if (has_subtitle(options_))
    pen.text(options_.subtitle.empty()
                 ? fmt::format("{}    step {}    {}{}{}", at, picture.now.step,
                               counted(present(picture.now), "block"),
                               cracks_text(picture.now),
                               equilibrium_text(picture.now, options_))
                 : options_.subtitle,
             margins_.left, margins_.subtitle, options_.page.printed ? 12.5 : 15, muted,
             0, 1, options_.page.width - margins_.left - 14);
}

void FigurePage::end(Pen& pen, const Picture& last) const {
  const Axes first = axes(0), lowest = axes(count_ - 1);
  const double right_of_pictures = axes(std::min(count_, columns_) - 1).right();
  const double width = options_.page.width - margins_.left - margins_.right;
  if (count_ > 1 && has_subtitle(options_))
    pen.text(!options_.subtitle.empty()
                 ? options_.subtitle
                 : counted(count_, "time") +
                       (scales_.block_counts.size() == 1
                            ? "    " + counted(present(last.now), "block")
                            : ""),
             margins_.left, margins_.subtitle, options_.page.printed ? 12.5 : 15, muted,
             0, 1, options_.page.width - margins_.left - 14);
  const double arrow = arrow_length(first, scales_);
  if (below_) {
    draw_legend(pen,
                {margins_.left, lowest.bottom() + margins_.foot, width, 0, arrow, true},
                last, scales_, options_);
    return;
  }
  const double beside = lowest.bottom() - first.top;
  const double height =
      std::max(lowest.bottom(), height_ - 0.5 * margins_.foot) - first.top;
  const double x = right_of_pictures + 16;
  draw_legend(pen,
              {x, first.top, std::min(options_.page.width - x, margins_.right - 16) - 8,
               beside < 300 ? height : beside, arrow, false},
              last, scales_, options_);
}

void FigurePage::rulers(Pen& pen, const Axes& axes, bool along_x, bool along_y) const {
  cairo_rectangle(pen.cairo(), axes.left, axes.top, axes.width, axes.height);
  pen.stroke(1.0, ink);
  const auto tick = [&](double x, double y, double dx, double dy) {
    pen.line(x, y, x + dx, y + dy, 1.0, ink);
  };
  const auto [xs, ys] = ticks_of(axes);
  for (std::size_t i = 0; i < xs.ticks.size(); ++i) {
    tick(axes.x(xs.ticks[i]), axes.bottom(), 0, along_x ? 6 : -5);
    if (!along_x)
      continue;
    // The last label may be wider than the margin.
    constexpr double edge = 4;
    const double max = options_.page.width - edge - 0.5 * pen.width(xs.labels[i], 14);
    pen.text(xs.labels[i], std::min(axes.x(xs.ticks[i]), max), axes.bottom() + 11, 14,
             ink, 0.5, 0);
  }
  for (std::size_t i = 0; i < ys.ticks.size(); ++i) {
    tick(axes.left, axes.y(ys.ticks[i]), along_y ? -6 : 5, 0);
    if (along_y)
      pen.text(ys.labels[i], axes.left - 11, axes.y(ys.ticks[i]), 14, ink, 1, 0.5,
               numbers_);
  }
  if (along_x) {
    pen.text(xs.axis_title(options_.with_unit("x", length)), axes.left + axes.width / 2,
             axes.bottom() + 38, 15, ink, 0.5, 0, axes.width);
  }
  if (along_y) {
    const double label = axes.left - numbers_ - 20;
    pen.upright(ys.axis_title(options_.with_unit("y", length)), label,
                axes.top + axes.height / 2, 15, ink, axes.height);
  }
}

}  // namespace blocks::post
