#include "post/figure_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "post/axes.hpp"
#include "post/quantity.hpp"
#include "post/scene_drawing.hpp"

namespace blocks::post {
namespace {

constexpr double line = 26;  ///< height of an entry

/// Writes its entries one below the other.
class Legend {
 public:
  Legend(Pen& pen, const LegendPlace& place, const Picture& picture,
         const FigureScales& scales, const FigureOptions& options)
      : pen_(pen), cairo_(pen.cairo()), place_(place), picture_(picture),
        scales_(scales), options_(options), y_(place.top + 2) {}

  void draw() {
    const bool by_material = options_.colour == "material";
    const bool forces = options_.forces && scales_.force > 0.0;
    if (by_material)
      materials();
    fixed();
    if (!options_.arrows.empty())
      arrow();
    const double room = place_.top + place_.height - y_;
    const double each =
        std::clamp(room / (forces && !by_material ? 2 : 1), 110.0, 460.0);
    if (!by_material) {
      const Quantity shown =
          quantity(options_.colour, picture_.now, picture_.first, picture_.contacts);
      bar(shown.label, shown.dimension, scales_.low, scales_.high, each,
          [&](double s) { return shade(shown.is_signed, s); });
    }
    if (forces)
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
    pen_.text(text, place_.x + 28, y_ + 7, 14, ink, 0, 0.5, Pen::page - place_.x - 32);
  }

  void materials() {
    const std::set<int> present(picture_.now.material.begin(),
                                picture_.now.material.end());
    for (const int material : present)
      swatch(colour_of_material(material, options_), false,
             fmt::format("material {}", material));
  }
  void fixed() {
    const auto& fixed = picture_.now.fixed;
    if (std::any_of(fixed.begin(), fixed.end(), [](int one) { return one != 0; }))
      swatch({0.9, 0.9, 0.9}, true, "fixed");
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
    pen_.text(fmt::format("{} {:.3g} {}", options_.arrows, scales_.arrow, unit),
              place_.x, y_ + 7, 13, ink, 0, 0.5, Pen::page - place_.x - 6);
    y_ += line;
  }

  void bar(const std::string& label, const Dimension& dimension, double low,
           double high, double room, const std::function<Colour(double)>& colour) {
    const double width = 22, top = y_ + 30, height = room - 50;
    const TickLabels marked =
        label_ticks(low, high, std::max(3, static_cast<int>(height / 50)));
    pen_.text(marked.titled(with_unit(label, dimension, options_)), place_.x, y_ + 4,
              14, ink, 0, 0, Pen::page - place_.x - 6);
    constexpr int steps = 128;
    for (int i = 0; i < steps; ++i) {
      pen_.colour(colour((steps - 0.5 - i) / steps));
      cairo_rectangle(cairo_, place_.x, top + height * i / steps, width,
                      height / steps + 0.6);
      cairo_fill(cairo_);
    }
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
    y_ += room;
  }

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
