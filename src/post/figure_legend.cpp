#include "post/figure_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "post/axes.hpp"
#include "post/quantity.hpp"
#include "post/scene_drawing.hpp"

namespace blocks::post {
namespace {

constexpr double line = 26;        ///< height of an entry
constexpr double small_line = 19;  ///< height of an entry if there are many materials
constexpr double least_bar = 170, most_bar = 460;
constexpr std::size_t few_materials = 10, columns = 3, most_materials = 90;

bool by_material(const FigureOptions& options) { return options.colour == "material"; }
bool with_forces(const FigureScales& scales, const FigureOptions& options) {
  return options.forces && scales.force > 0.0;
}
int bars(const FigureScales& scales, const FigureOptions& options) {
  return (by_material(options) ? 0 : 1) + (with_forces(scales, options) ? 1 : 0);
}
double materials_height(std::size_t count) {
  if (count <= few_materials)
    return static_cast<double>(count) * line;
  const std::size_t shown = std::min(count, most_materials),
                    rows = (shown + columns - 1) / columns;
  return static_cast<double>(rows + 1) * small_line + 10;
}

/// Draws the entries of the legend from top to bottom.
class Legend {
 public:
  Legend(Pen& pen, const LegendPlace& place, const Picture& picture,
         const FigureScales& scales, const FigureOptions& options)
      : pen_(pen), cairo_(pen.cairo()), place_(place), picture_(picture),
        scales_(scales), options_(options), y_(place.top + 2) {}

  void draw() {
    if (by_material(options_))
      materials();
    if (scales_.fixed)
      swatch({0.9, 0.9, 0.9}, true, "fixed");
    if (!options_.arrows.empty())
      arrow();
    const double room = place_.top + place_.height - y_;
    const double each =
        std::clamp(room / std::max(1, bars(scales_, options_)), least_bar, most_bar);
    if (!by_material(options_)) {
      const Quantity shown =
          quantity(options_.colour, picture_.now, picture_.first, picture_.contacts);
      bar(shown.label, shown.dimension, scales_.low, scales_.high, each,
          [&](double s) { return shade(shown.is_signed, s); });
    }
    if (with_forces(scales_, options_))
      bar("contact force", {0, 1, -2, "N/m", ""}, 0.0, scales_.force, each, intensity);
    marks();
  }

 private:
  void swatch(const Colour& fill, bool hatched, const std::string& name) {
    cairo_rectangle(cairo_, place_.x, y_, 20, 14);
    pen_.colour(fill);
    cairo_fill_preserve(cairo_);
    if (hatched)
      hatch(pen_, fill);
    pen_.stroke(0.8, ink);
    words(name);
    y_ += line;
  }
  void words(const std::string& text) {
    pen_.text(text, place_.x + 28, y_ + 7, 14, ink, 0, 0.5, room() - 28);
  }

  /// Draws many materials as numbers only, side by side.
  void materials() {
    const auto& present = scales_.materials;
    if (present.size() <= few_materials) {
      for (const int material : present)
        swatch(colour_of_material(material, options_), false,
               fmt::format("material {}", material));
      return;
    }
    const double top = y_, across = room() / columns;
    const bool all = present.size() <= most_materials;
    pen_.text(all ? "materials"
                  : fmt::format("{} of {} materials", most_materials, present.size()),
              place_.x, y_ + 6, 14, ink, 0, 0.5, room());
    std::size_t i = 0;
    for (const int material : present) {
      if (i == most_materials)
        break;
      const std::size_t column = i % columns, row = i / columns;
      const double x = place_.x + across * static_cast<double>(column);
      y_ = top + small_line * static_cast<double>(row + 1);
      cairo_rectangle(cairo_, x, y_, 13, 11);
      pen_.colour(colour_of_material(material, options_));
      cairo_fill_preserve(cairo_);
      pen_.stroke(0.7, ink);
      pen_.text(std::to_string(material), x + 17, y_ + 5.5, 11, ink, 0, 0.5,
                across - 20);
      ++i;
    }
    y_ = top + materials_height(present.size());
  }

  void arrow() {
    static const std::map<std::string, Dimension> dimensions = {
        {"velocity", {1, 0, -1, "m/s", ""}},
        {"displacement", {1, 0, 0, "m", ""}},
        {"force", {0, 1, -2, "N/m", ""}}};
    if (scales_.arrow > 0.0)
      draw_arrow(pen_, place_.x, y_ + 7, place_.arrow, 0);
    y_ += line - 6;
    const std::string unit = unit_text(dimensions.at(options_.arrows), options_.units);
    pen_.text(options_.arrows, place_.x, y_ + 6, 13, ink, 0, 0.5, room());
    pen_.text(fmt::format("{:.3g} {}", scales_.arrow, unit), place_.x, y_ + 22, 13, ink,
              0, 0.5, room());
    y_ += 42;
  }

  void bar(const std::string& label, const Dimension& dimension, double low,
           double high, double room, const std::function<Colour(double)>& colour) {
    const double width = 22, end = y_ + room;
    const TickLabels marked =
        label_ticks(low, high, std::max(3, static_cast<int>((room - 70) / 50)));
    y_ += pen_.paragraph(marked.titled(with_unit(label, dimension, options_)), place_.x,
                         y_, 14, ink, this->room());
    const double top = y_ + 10, height = end - 24 - top;
    cairo_pattern_t* shades = cairo_pattern_create_linear(0, top + height, 0, top);
    constexpr int steps = 64;
    for (int i = 0; i <= steps; ++i) {
      const double at = static_cast<double>(i) / steps;
      const Colour c = colour(at);
      cairo_pattern_add_color_stop_rgb(shades, at, c.r, c.g, c.b);
    }
    cairo_rectangle(cairo_, place_.x, top, width, height);
    cairo_set_source(cairo_, shades);
    cairo_fill(cairo_);
    cairo_pattern_destroy(shades);
    cairo_rectangle(cairo_, place_.x, top, width, height);
    pen_.stroke(0.8, ink);
    for (std::size_t i = 0; i < marked.ticks.size(); ++i) {
      const double y = top + height * (high - marked.ticks[i]) / (high - low);
      cairo_move_to(cairo_, place_.x + width, y);
      cairo_rel_line_to(cairo_, 5, 0);
      pen_.stroke(0.8, ink);
      pen_.text(marked.labels[i], place_.x + width + 9, y, 13, ink, 0, 0.5);
    }
    pen_.text(marked.offset, place_.x, top + height + 6, 13, ink, 0, 0);
    y_ = end;
  }

  double room() const { return Pen::page - place_.x - 8; }

  void marks() {
    y_ += 8;
    for (const MarkName& entry : options_.mark_names) {
      trace_mark(cairo_, entry.kind, place_.x + 10, y_ + 7, 6);
      pen_.stroke(2.2, mark_colour(entry.kind));
      words(entry.name);
      y_ += 18;
      pen_.text(entry.count, place_.x + 28, y_ + 7, 12, faint, 0, 0.5);
      y_ += 24;
    }
  }

  Pen& pen_;
  cairo_t* cairo_;
  const LegendPlace& place_;
  const Picture& picture_;
  const FigureScales& scales_;
  const FigureOptions& options_;
  double y_;
};

}  // namespace

double legend_height(const FigureScales& scales, const FigureOptions& options) {
  constexpr double arrow = 62, mark = 42;
  return (by_material(options) ? materials_height(scales.materials.size()) : 0) +
         (scales.fixed ? line : 0) + (options.arrows.empty() ? 0 : arrow) +
         bars(scales, options) * least_bar +
         mark * static_cast<double>(options.mark_names.size());
}

void draw_legend(Pen& pen, const LegendPlace& place, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options) {
  Legend(pen, place, picture, scales, options).draw();
}

std::string with_unit(const std::string& label, const Dimension& dimension,
                      const FigureOptions& options) {
  const std::string unit = unit_text(dimension, options.units);
  return unit.empty() ? label : label + " [" + unit + "]";
}

}  // namespace blocks::post
