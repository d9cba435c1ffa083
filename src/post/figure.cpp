#include "post/figure.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "post/axes.hpp"
#include "post/colour_map.hpp"
#include "post/page_file.hpp"
#include "post/quantity.hpp"

namespace blocks::post {
namespace {

constexpr Colour ink{0.16, 0.16, 0.18}, faint{0.62, 0.62, 0.64},
    paper{0.992, 0.99, 0.984};

/// Draws one frame; holds what all parts share.
class Drawing {
 public:
  Drawing(cairo_t* pen, const Axes& axes, const Frame& now, const Frame& first,
          const FigureOptions& options)
      : pen_(pen), axes_(axes), now_(now), first_(first), options_(options),
        unit_(axes.page_width / 1200.0) {
    cairo_select_font_face(pen_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(pen_, CAIRO_LINE_JOIN_ROUND);
  }

  void draw(const std::string& title) {
    colour(paper);
    cairo_paint(pen_);
    const bool by_material = options_.colour == "material";
    if (!by_material)
      set_range(quantity(options_.colour, now_, first_));
    cairo_save(pen_);
    cairo_rectangle(pen_, axes_.left, axes_.top, axes_.width, axes_.height);
    colour({1, 1, 1});
    cairo_fill_preserve(pen_);
    cairo_clip(pen_);
    for (const bool mirrored : {true, false}) {
      if (mirrored && !options_.mirror)
        continue;
      mirrored_ = mirrored;
      if (options_.original)
        original();
      for (std::size_t b = 0; b < now_.outlines.size(); ++b)
        block(b);
    }
    if (options_.mirror)
      centre_line();
    marks();
    cairo_restore(pen_);
    frame_and_ticks();
    heading(title);
    by_material ? legend() : colour_bar();
  }

 private:
  void colour(const Colour& c, double alpha = 1.0) {
    cairo_set_source_rgba(pen_, c.r, c.g, c.b, alpha);
  }
  double page_x(double x) const {
    return axes_.x(mirrored_ ? 2.0 * options_.mirror_x - x : x);
  }
  void path(const std::vector<Eigen::Vector2d>& outline) {
    for (const Eigen::Vector2d& p : outline)
      cairo_line_to(pen_, page_x(p.x()), axes_.y(p.y()));
    cairo_close_path(pen_);
  }

  void set_range(Quantity chosen) {
    quantity_ = std::move(chosen);
    low_ = quantity_.values.size() ? quantity_.values.minCoeff() : 0.0;
    high_ = quantity_.values.size() ? quantity_.values.maxCoeff() : 1.0;
    if (quantity_.is_signed) {
      high_ = std::max(std::abs(low_), std::abs(high_));
      low_ = -high_;
    } else {
      low_ = std::min(0.0, low_);
    }
    if (!(high_ > low_))
      high_ = low_ + 1.0;
  }
  Colour colour_of(int material) const {
    const auto chosen = options_.material_colours.find(material);
    return chosen == options_.material_colours.end() ? material_colour(material)
                                                     : chosen->second;
  }
  Colour mapped(double value) const {
    const double s = (value - low_) / (high_ - low_);
    return quantity_.is_signed ? diverging(s) : sequential(s);
  }

  void block(std::size_t b) {
    const auto& outline = now_.outlines[b];
    path(outline);
    const bool by_material = options_.colour == "material";
    const Colour fill = by_material
                            ? colour_of(now_.material[b])
                            : mapped(quantity_.values[static_cast<Eigen::Index>(b)]);
    colour(fill);
    cairo_fill_preserve(pen_);
    if (now_.fixed[b] != 0)
      hatch();
    const double size = extent(outline) * axes_.scale();
    cairo_set_line_width(pen_, std::clamp(0.03 * size, 0.25, 1.1) * unit_);
    colour({0.55 * fill.r * 0.6, 0.55 * fill.g * 0.6, 0.55 * fill.b * 0.6}, 0.9);
    cairo_stroke(pen_);
    if (options_.numbers && !mirrored_)
      number(b, size);
  }

  static double extent(const std::vector<Eigen::Vector2d>& outline) {
    Eigen::Vector2d low = outline.front(), high = outline.front();
    for (const Eigen::Vector2d& p : outline) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return (high - low).minCoeff();
  }

  /// Slanting lines over the present path: a fixed block.
  void hatch() {
    double x0, y0, x1, y1;
    cairo_path_extents(pen_, &x0, &y0, &x1, &y1);
    cairo_path_t* outline = cairo_copy_path(pen_);
    cairo_save(pen_);
    cairo_clip(pen_);
    const double gap = 9.0 * unit_;
    // a block far larger than the page needs no lines outside it
    x0 = std::max(x0, 0.0), x1 = std::min(x1, axes_.page_width);
    y0 = std::max(y0, 0.0), y1 = std::min(y1, axes_.page_height);
    for (double x = std::floor((x0 - (y1 - y0)) / gap) * gap; x < x1; x += gap) {
      cairo_move_to(pen_, x, y1);
      cairo_line_to(pen_, x + (y1 - y0), y0);
    }
    cairo_set_line_width(pen_, 1.0 * unit_);
    colour({0.1, 0.1, 0.1}, 0.35);
    cairo_stroke(pen_);
    cairo_restore(pen_);
    cairo_append_path(pen_, outline);
    cairo_path_destroy(outline);
  }

  void number(std::size_t b, double size) {
    const std::string text = std::to_string(now_.number[b]);
    text_at(text, page_x(now_.centroid(0, static_cast<Eigen::Index>(b))),
            axes_.y(now_.centroid(1, static_cast<Eigen::Index>(b))),
            std::clamp(0.42 * size / unit_, 5.0, 16.0), ink, 0.5, 0.5);
  }

  void original() {
    const double dashes[] = {4 * unit_, 3 * unit_};
    cairo_set_dash(pen_, dashes, 2, 0);
    cairo_set_line_width(pen_, 0.7 * unit_);
    colour(faint);
    for (const auto& outline : first_.outlines) {
      path(outline);
      cairo_stroke(pen_);
    }
    cairo_set_dash(pen_, nullptr, 0, 0);
  }

  /// Blocks tinted, what two blocks share filled, a ring around the place.
  void marks() {
    for (const Mark& mark : options_.marks) {
      const Colour c = mark_colour(mark.kind);
      cairo_save(pen_);
      for (const int b : mark.blocks) {
        path(now_.outlines[static_cast<std::size_t>(b)]);
        if (mark.kind == Mark::Kind::overlap) {
          cairo_clip(pen_);  // one after the other: the common part is left
        } else {
          colour(c, 0.35);
          cairo_fill(pen_);
        }
      }
      if (mark.kind == Mark::Kind::overlap) {
        colour(c, 0.85);
        cairo_paint(pen_);
      }
      cairo_restore(pen_);
    }
    for (const Mark& mark : options_.marks) {
      const Colour c = mark_colour(mark.kind);
      const double x = page_x(mark.place.x()), y = axes_.y(mark.place.y());
      trace_mark(pen_, mark.kind, x, y, 9 * unit_);
      cairo_set_line_width(pen_, 4.5 * unit_);
      colour(paper, 0.9);
      cairo_stroke_preserve(pen_);
      cairo_set_line_width(pen_, 2.2 * unit_);
      colour(c);
      cairo_stroke(pen_);
      if (!mark.label.empty())
        tag(mark.label, x + 16 * unit_, y - 14 * unit_, c);
    }
  }

  /// Text on a piece of paper, readable on any ground.
  void tag(const std::string& text, double x, double y, const Colour& c) {
    cairo_set_font_size(pen_, 13 * unit_);
    cairo_text_extents_t box;
    cairo_text_extents(pen_, text.c_str(), &box);
    const double edge = 4 * unit_;
    cairo_rectangle(pen_, x - edge, y - 0.5 * box.height - edge, box.width + 2 * edge,
                    box.height + 2 * edge);
    colour(paper, 0.85);
    cairo_fill(pen_);
    text_at(text, x, y, 13, c, 0, 0.5);
  }

  void mark_legend(double x, double y) {
    for (const MarkName& entry : options_.mark_names) {
      trace_mark(pen_, entry.kind, x + 10 * unit_, y + 7 * unit_, 6 * unit_);
      cairo_set_line_width(pen_, 2.2 * unit_);
      colour(mark_colour(entry.kind));
      cairo_stroke(pen_);
      text_at(entry.name, x + 28 * unit_, y + 7 * unit_, 14, ink, 0, 0.5);
      y += 18 * unit_;
      text_at(entry.count, x + 28 * unit_, y + 7 * unit_, 12, faint, 0, 0.5);
      y += 24 * unit_;
    }
  }

  void centre_line() {
    const double dashes[] = {14 * unit_, 4 * unit_, 3 * unit_, 4 * unit_};
    cairo_set_dash(pen_, dashes, 4, 0);
    cairo_set_line_width(pen_, 1.2 * unit_);
    colour(ink, 0.8);
    cairo_move_to(pen_, axes_.x(options_.mirror_x), axes_.top);
    cairo_line_to(pen_, axes_.x(options_.mirror_x), axes_.top + axes_.height);
    cairo_stroke(pen_);
    cairo_set_dash(pen_, nullptr, 0, 0);
  }

  /// along, up: which part of the text stands at (x, y); 0 left or top, 1 right or
  /// bottom.
  void text_at(const std::string& text, double x, double y, double size,
               const Colour& c, double along, double up) {
    cairo_set_font_size(pen_, size * unit_);
    cairo_text_extents_t box;
    cairo_text_extents(pen_, text.c_str(), &box);
    colour(c);
    cairo_move_to(pen_, x - box.x_bearing - along * box.width,
                  y - box.y_bearing - up * box.height);
    cairo_show_text(pen_, text.c_str());
    cairo_new_path(pen_);
  }

  void frame_and_ticks() {
    const double bottom = axes_.top + axes_.height;
    cairo_set_line_width(pen_, 1.0 * unit_);
    colour(ink);
    cairo_rectangle(pen_, axes_.left, axes_.top, axes_.width, axes_.height);
    cairo_stroke(pen_);
    const TickLabels xs = label_ticks(axes_.xmin, axes_.xmax, 10);
    for (std::size_t i = 0; i < xs.ticks.size(); ++i) {
      tick(axes_.x(xs.ticks[i]), bottom, 0, 6);
      text_at(xs.labels[i], axes_.x(xs.ticks[i]), bottom + 11 * unit_, 14, ink, 0.5, 0);
    }
    text_at(xs.offset, axes_.left + axes_.width, bottom + 38 * unit_, 14, ink, 1, 0);
    const TickLabels ys =
        label_ticks(axes_.ymin, axes_.ymax,
                    std::max(2, static_cast<int>(axes_.height / (70 * unit_))));
    for (std::size_t i = 0; i < ys.ticks.size(); ++i) {
      tick(axes_.left, axes_.y(ys.ticks[i]), -6, 0);
      text_at(ys.labels[i], axes_.left - 11 * unit_, axes_.y(ys.ticks[i]), 14, ink, 1,
              0.5);
    }
    text_at(ys.offset, axes_.left - 66 * unit_, axes_.top - 5 * unit_, 14, ink, 0, 1);
    text_at("x", axes_.left + axes_.width / 2, bottom + 38 * unit_, 15, ink, 0.5, 0);
    text_at("y", axes_.left - 66 * unit_, axes_.top + axes_.height / 2, 15, ink, 0,
            0.5);
  }
  void tick(double x, double y, double dx, double dy) {
    colour(ink);
    cairo_move_to(pen_, x, y);
    cairo_rel_line_to(pen_, dx * unit_, dy * unit_);
    cairo_stroke(pen_);
  }

  void heading(const std::string& title) {
    text_at(title.empty() ? "BLOCKS" : title, axes_.left, 34 * unit_, 21, ink, 0, 1);
    text_at(options_.subtitle.empty()
                ? fmt::format("t = {:.4g}    step {}    {} blocks", now_.time,
                              now_.step, now_.outlines.size())
                : options_.subtitle,
            axes_.left, 62 * unit_, 15, {0.36, 0.36, 0.4}, 0, 1);
  }

  void swatch(double x, double y, const Colour& fill, bool hatched) {
    cairo_rectangle(pen_, x, y, 20 * unit_, 14 * unit_);
    colour(fill);
    cairo_fill_preserve(pen_);
    if (hatched)
      hatch();
    cairo_set_line_width(pen_, 0.8 * unit_);
    colour(ink);
    cairo_stroke(pen_);
  }

  void legend() {
    std::map<int, bool> materials;  // number, and whether any block is fixed
    bool any_fixed = false;
    for (std::size_t b = 0; b < now_.outlines.size(); ++b) {
      materials[now_.material[b]] = true;
      any_fixed = any_fixed || now_.fixed[b] != 0;
    }
    const double x = axes_.left + axes_.width + 14 * unit_;
    double y = axes_.top + 2 * unit_;
    for (const auto& [material, unused] : materials) {
      swatch(x, y, colour_of(material), false);
      text_at(fmt::format("material {}", material), x + 28 * unit_, y + 7 * unit_, 14,
              ink, 0, 0.5);
      y += 26 * unit_;
    }
    if (any_fixed) {
      swatch(x, y, {0.9, 0.9, 0.9}, true);
      text_at("fixed", x + 28 * unit_, y + 7 * unit_, 14, ink, 0, 0.5);
      y += 26 * unit_;
    }
    mark_legend(x, y + 8 * unit_);
  }

  void colour_bar() {
    const double x = axes_.left + axes_.width + 18 * unit_, w = 22 * unit_;
    const double top = axes_.top + 30 * unit_;
    const double height = std::min(axes_.height - 40 * unit_, 420 * unit_);
    constexpr int steps = 128;
    for (int i = 0; i < steps; ++i) {
      colour(mapped(low_ + (high_ - low_) * (steps - 0.5 - i) / steps));
      cairo_rectangle(pen_, x, top + height * i / steps, w, height / steps + 0.6);
      cairo_fill(pen_);
    }
    cairo_set_line_width(pen_, 0.8 * unit_);
    colour(ink);
    cairo_rectangle(pen_, x, top, w, height);
    cairo_stroke(pen_);
    for (const double t : nice_ticks(low_, high_, 6)) {
      const double y = top + height * (high_ - t) / (high_ - low_);
      tick(x + w, y, 5, 0);
      text_at(fmt::format("{:.4g}", t), x + w + 9 * unit_, y, 13, ink, 0, 0.5);
    }
    text_at(quantity_.label, x, axes_.top + 4 * unit_, 14, ink, 0, 0);
  }

  cairo_t* pen_;
  const Axes& axes_;
  const Frame &now_, &first_;
  const FigureOptions& options_;
  double unit_;
  Quantity quantity_;
  double low_ = 0.0, high_ = 1.0;
  bool mirrored_ = false;
};

/// What is shown: the zoom, or all corners (now and, if asked for, at first) with a
/// margin.
Axes choose_axes(const Frame& now, const Frame& first, const FigureOptions& options) {
  if (options.zoom) {
    const Eigen::Vector4d& z = *options.zoom;
    if (!(z[0] < z[1] && z[2] < z[3]))
      throw std::runtime_error("the zoom needs xmin < xmax and ymin < ymax");
    return {z[0], z[1], z[2], z[3], options.width};
  }
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
  const auto include = [&](const Frame& frame) {
    for (const auto& outline : frame.outlines)
      for (const Eigen::Vector2d& p : outline) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        if (options.mirror) {
          const Eigen::Vector2d q(2.0 * options.mirror_x - p.x(), p.y());
          low = low.cwiseMin(q);
          high = high.cwiseMax(q);
        }
      }
  };
  include(now);
  if (options.original)
    include(first);
  if (!(low.x() <= high.x()))
    low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Ones();
  const double margin = std::max(0.03 * (high - low).maxCoeff(), 1e-12);
  return {low.x() - margin, high.x() + margin, low.y() - margin, high.y() + margin,
          options.width};
}

}  // namespace

void draw_frame(const std::string& path, const Frame& now, const Frame& first,
                const std::string& title, const FigureOptions& options) {
  const Axes axes = choose_axes(now, first, options);
  write_page(path, axes.page_width, axes.page_height, [&](cairo_t* pen) {
    Drawing(pen, axes, now, first, options).draw(title);
  });
}

void draw_figure(const std::string& path, const ResultsReader& results, long frame,
                 const FigureOptions& options) {
  draw_frame(path, results.frame(frame), results.frame(0), results.title(), options);
}

}  // namespace blocks::post
