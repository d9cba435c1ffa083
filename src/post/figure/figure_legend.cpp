#include "post/figure/figure_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "draw/axes.hpp"
#include "draw/joint_colours.hpp"
#include "post/figure/arrows.hpp"
#include "post/figure/scene_drawing.hpp"
#include "post/figure/sides.hpp"
#include "post/figure/symbols.hpp"
#include "post/read/frame_quantity.hpp"

namespace blocks::post {

using namespace draw;

namespace {

constexpr double line = 26;        ///< height of an entry
constexpr double small_line = 19;  ///< height of an entry if there are many materials
constexpr double min_bar = 170, max_bar = 460;
constexpr double min_column = 32;  ///< width of an entry if there are many materials
constexpr std::size_t few_materials = 10, max_materials = 90;
constexpr double cell = 116, cell_line = 20;  ///< an entry of a legend below
constexpr double low_bar = 62;                ///< height of a bar in a legend below
constexpr double tip_length = 6;              ///< of a bar that cuts values
constexpr double arrow_line = 26;             ///< height of the arrow in a legend below

/// The ends of a bar beyond which there are values.
struct Cut {
  bool low = false, high = false;
};

bool by_material(const FigureOptions& options) { return !options.shows_quantity(); }
bool with_forces(const FigureScales& scales, const FigureOptions& options) {
  return options.forces && scales.force > 0.0;
}
int bars(const FigureScales& scales, const FigureOptions& options) {
  return (options.shows_values() ? 1 : 0) + (with_forces(scales, options) ? 1 : 0) +
         (scales.slip > 0.0 ? 1 : 0);
}
std::size_t columns_of(double width) {
  return static_cast<std::size_t>(std::max(3.0, std::floor(width / min_column)));
}
double many_materials_height(std::size_t count, double width) {
  const std::size_t shown = std::min(count, max_materials), columns = columns_of(width),
                    rows = (shown + columns - 1) / columns;
  return static_cast<double>(rows + 1) * small_line + 10;
}
/// Returns the number of entries for joints: those listed, how many more there are, and
/// the sides without a joint; or for the states of bonds.
std::size_t joint_entries(const FigureScales& scales) {
  const std::size_t count = scales.joints.size();
  const std::size_t bonds = scales.bonds.empty() ? 0 : scales.bonds.size() + 1;
  return (count == 0 ? 0 : std::min(count, max_joints_listed + 1) + 1) + bonds;
}
double materials_height(std::size_t count) {
  return count <= few_materials ? static_cast<double>(count) * line
                                : many_materials_height(count, 0.0);
}

/// Draws the entries of the legend from top to bottom.
class Legend {
 public:
  Legend(Pen& pen, const LegendPlace& place, const Picture& picture,
         const FigureScales& scales, const FigureOptions& options)
      : pen_(pen), cairo_(pen.cairo()), place_(place), picture_(picture),
        scales_(scales), options_(options), y_(place.top + 2) {}

  void draw() {
    joints();
    bonds();
    if (by_material(options_))
      materials();
    if (scales_.cracks)
      line_swatch(crack_colour, 2.6, "crack");
    if (scales_.fixed)
      swatch({0.9, 0.9, 0.9}, true, "fixed");
    if (!options_.planes.empty())
      plane();
    if (scales_.water)
      line_swatch(water_colour, 1.6, "water table");
    end_cells();
    if (!options_.arrows.empty())
      arrow();
    const double height = place_.top + place_.height - y_;
    const double each =
        std::clamp(height / std::max(1, bars(scales_, options_)), min_bar, max_bar);
    if (options_.shows_values()) {
      const Quantity shown = options_.shows_faces()
                                 ? face_quantity(options_.colour)
                                 : quantity(options_.colour, picture_.now,
                                            picture_.first, picture_.contacts);
      const ColourMap map = map_of(options_, shown.zero, scales_.colours);
      if (scales_.is_zero)
        zero(shown.label, shown.dimension, each, map.at(scales_.colours.place(0.0)));
      else
        bar(shown.label, shown.dimension, scales_.colours, each,
            [&](double s) { return map.at(s); }, {scales_.cuts_low, scales_.cuts_high});
    }
    if (scales_.slip > 0.0)
      bar("slip", {1, 0, 0, "m", ""}, {0.0, scales_.slip}, each, slip_colour);
    if (with_forces(scales_, options_))
      bar("contact force", {0, 1, -2, "N/m", ""}, {0.0, scales_.force}, each,
          intensity);
    marks();
  }

 private:
  void swatch(const Colour& fill, bool hatched, const std::string& name) {
    const double x = place_.x + across_;
    cairo_rectangle(cairo_, x, y_, 20, 14);
    pen_.colour(fill);
    cairo_fill_preserve(cairo_);
    if (hatched)
      hatch(pen_, fill);
    pen_.stroke(0.8, ink);
    end_entry(name);
  }
  /// Draws a line of the width that it has in the picture.
  void line_swatch(const Colour& colour, double width, const std::string& name) {
    const double x = place_.x + across_;
    pen_.line(x, y_ + 7, x + 20, y_ + 7, width, colour);
    pen_.dashes({});
    end_entry(name);
  }
  void plane() {
    const double x = place_.x + across_;
    draw_plane(pen_, {x, y_ + 5}, {x + 20, y_ + 5});
    end_entry("plane");
  }
  /// Writes the name of an entry beside its symbol, and goes to the next entry.
  void end_entry(const std::string& name) {
    pen_.text(name, place_.x + across_ + 28, y_ + 7, 14, ink, 0, 0.5,
              (place_.below ? cell : width()) - 28);
    if (!place_.below) {
      y_ += line;
      return;
    }
    across_ += cell;
    if (across_ + cell > width())
      end_cells();
  }
  /// Begins a new row of a legend below, unless the row is empty.
  void end_cells() {
    y_ += across_ > 0.0 ? cell_line : 0.0;
    across_ = 0.0;
  }

  void joints() {
    if (scales_.joints.empty())
      return;
    std::size_t listed = 0;
    for (const int id : scales_.joints) {
      if (++listed > max_joints_listed)
        break;
      set_joint_dashes(pen_, id);
      line_swatch(joint_colour(id), 3.0, fmt::format("joint {}", id));
    }
    if (scales_.joints.size() > max_joints_listed)
      end_entry(fmt::format("and {} more", scales_.joints.size() - max_joints_listed));
    line_swatch(no_joint_colour, 1.0, "no joint");
  }

  /// Faces that have failed have the colours of the bar of slip, if there is one.
  void bonds() {
    if (scales_.bonds.empty())
      return;
    for (const quantities::Bond bond : scales_.bonds) {
      const bool failed =
          bond == quantities::Bond::failed || bond == quantities::Bond::weakened;
      set_bond_dashes(pen_, bond);
      line_swatch(failed ? slip_colour(scales_.slip > 0.0 ? 0.5 : 0.0) : bonded_colour,
                  3.0, quantities::word(bond));
    }
    line_swatch(no_joint_colour, 1.0, "other");  // open, or without a law
  }

  std::string material_text(int material) const {
    if (options_.shows_families())
      return material == 0 ? "whole blocks" : fmt::format("from block {}", material);
    const auto name = options_.material_names.find(material);
    return name == options_.material_names.end() ? fmt::format("material {}", material)
                                                 : name->second;
  }

  /// Draws many materials as numbers only, side by side.
  void materials() {
    const auto& present = scales_.materials;
    if (present.size() <= few_materials) {
      for (const int material : present)
        swatch(colour_of_material(material, options_), false, material_text(material));
      return;
    }
    end_cells();
    const std::size_t columns = columns_of(place_.below ? width() : 0.0);
    const double top = y_, across = width() / static_cast<double>(columns);
    const bool all = present.size() <= max_materials;
    const char* const name = options_.shows_families() ? "from blocks" : "materials";
    pen_.text(all ? name
                  : fmt::format("{} of {} {}", max_materials, present.size(), name),
              place_.x, y_ + 6, 14, ink, 0, 0.5, width());
    std::size_t i = 0;
    for (const int material : present) {
      if (i == max_materials)
        break;
      const std::size_t column = i % columns, row = i / columns;
      const double x = place_.x + across * static_cast<double>(column);
      y_ = top + small_line * static_cast<double>(row + 1);
      cairo_rectangle(cairo_, x, y_, 13, 11);
      pen_.fill_and_stroke(colour_of_material(material, options_), 0.7, ink);
      pen_.text(std::to_string(material), x + 17, y_ + 5.5, 11, ink, 0, 0.5,
                across - 20);
      ++i;
    }
    y_ = top + many_materials_height(present.size(), place_.below ? width() : 0.0);
  }

  void arrow() {
    static const std::map<std::string, Dimension> dimensions = {
        {"velocity", {1, 0, -1, "m/s", ""}},
        {"displacement", {1, 0, 0, "m", ""}},
        {"force", {0, 1, -2, "N/m", ""}}};
    if (scales_.arrow > 0.0)
      draw_arrow(pen_, place_.x, y_ + 7, place_.arrow, 0);
    const std::string unit = unit_text(dimensions.at(options_.arrows), options_.units);
    const std::string value = fmt::format(
        "{}{:.3g} {}", scales_.cuts_arrows ? "≥ " : "", scales_.arrow, unit);
    if (place_.below) {
      pen_.text(options_.arrows + " " + value, place_.x + place_.arrow + 10, y_ + 7, 14,
                ink, 0, 0.5, width() - place_.arrow - 10);
      y_ += arrow_line;
      return;
    }
    y_ += line - 6;
    pen_.text(options_.arrows, place_.x, y_ + 6, 13, ink, 0, 0.5, width());
    pen_.text(value, place_.x, y_ + 22, 13, ink, 0, 0.5, width());
    y_ += 42;
  }

  /// Draws the one colour of a quantity that is 0 everywhere, in the space of a bar.
  void zero(const std::string& label, const Dimension& dimension, double height,
            const Colour& colour) {
    const double end = y_ + (place_.below ? low_bar : height);
    y_ += 4 + pen_.paragraph(options_.with_unit(label, dimension), place_.x, y_, 14,
                             ink, width());
    swatch(colour, false, "0 everywhere");
    across_ = 0.0;
    y_ = end;
  }

  /// Draws a triangle with its base from a to b that points outwards to c.
  void tip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Colour& colour) {
    for (const Eigen::Vector2d& corner : {a, c, b})
      cairo_line_to(cairo_, corner.x(), corner.y());
    cairo_close_path(cairo_);
    pen_.fill_and_stroke(colour, 0.8, ink);
  }

  void bar(const std::string& label, const Dimension& dimension,
           const ValueRange& range, double height,
           const std::function<Colour(double)>& colour, Cut cut = {}) {
    if (place_.below) {
      bar_along(label, dimension, range, colour, cut);
      return;
    }
    const double thick = 22, end = y_ + height;
    const TickLabels marked =
        range.ticks(std::max(3, static_cast<int>((height - 70) / 50)));
    y_ += pen_.paragraph(marked.titled(options_.with_unit(label, dimension)), place_.x,
                         y_, 14, ink, width());
    const double top = y_ + 10, tall = end - 24 - top;
    fill_bar(cairo_pattern_create_linear(0, top + tall, 0, top),
             {place_.x, top, thick, tall}, colour);
    const double x = place_.x, middle = x + 0.5 * thick, bottom = top + tall;
    if (cut.high)
      tip({x, top}, {x + thick, top}, {middle, top - tip_length}, colour(1.0));
    if (cut.low)
      tip({x, bottom}, {x + thick, bottom}, {middle, bottom + tip_length}, colour(0.0));
    for (std::size_t i = 0; i < marked.ticks.size(); ++i) {
      const double y = top + tall * (1.0 - range.place(marked.ticks[i]));
      pen_.line(x + thick, y, x + thick + 5, y, 0.8, ink);
      pen_.text(marked.labels[i], place_.x + thick + 9, y, 13, ink, 0, 0.5);
    }
    pen_.text(marked.offset, place_.x, top + tall + 6, 13, ink, 0, 0);
    y_ = end;
  }

  /// Draws a bar from left to right with its label above it and numbers below it.
  void bar_along(const std::string& label, const Dimension& dimension,
                 const ValueRange& range, const std::function<Colour(double)>& colour,
                 Cut cut) {
    constexpr double thick = 11, margin = tip_length;
    const double left = place_.x + margin, width = this->width() - 2 * margin,
                 top = y_ + 20;
    const TickLabels marked = range.ticks(std::max(3, static_cast<int>(width / 70)));
    pen_.text(marked.titled(options_.with_unit(label, dimension)), left, y_ + 8, 14,
              ink, 0, 0.5, width);
    fill_bar(cairo_pattern_create_linear(left, 0, left + width, 0),
             {left, top, width, thick}, colour);
    const double end = left + width, middle = top + 0.5 * thick;
    if (cut.high)
      tip({end, top}, {end, top + thick}, {end + tip_length, middle}, colour(1.0));
    if (cut.low)
      tip({left, top}, {left, top + thick}, {left - tip_length, middle}, colour(0.0));
    for (std::size_t i = 0; i < marked.ticks.size(); ++i) {
      const double x = left + width * range.place(marked.ticks[i]);
      pen_.line(x, top + thick, x, top + thick + 4, 0.8, ink);
      const double last =
          place_.x + this->width() - 0.5 * pen_.width(marked.labels[i], 13);
      pen_.text(marked.labels[i], std::min(x, last), top + thick + 7, 13, ink, 0.5, 0);
    }
    pen_.text(marked.offset, left + width, y_ + 8, 13, ink, 1, 0.5);
    y_ += low_bar;
  }

  /// Fills a box (x, y, width, height) with the colours along the pattern, and frees
  /// the pattern.
  void fill_bar(cairo_pattern_t* shades, const Eigen::Vector4d& box,
                const std::function<Colour(double)>& colour) {
    constexpr int steps = 64;
    for (int i = 0; i <= steps; ++i) {
      const double at = static_cast<double>(i) / steps;
      const Colour c = colour(at);
      cairo_pattern_add_color_stop_rgb(shades, at, c.r, c.g, c.b);
    }
    cairo_rectangle(cairo_, box[0], box[1], box[2], box[3]);
    cairo_set_source(cairo_, shades);
    cairo_fill_preserve(cairo_);
    cairo_pattern_destroy(shades);
    pen_.stroke(0.8, ink);
  }

  double width() const { return place_.width; }

  void marks() {
    y_ += 8;
    for (const MarkName& entry : options_.mark_names) {
      trace_mark(cairo_, entry.kind, place_.x + 10, y_ + 7, 6);
      pen_.stroke(2.2, mark_colour(entry.kind));
      pen_.text(entry.name, place_.x + 28, y_ + 7, 14, ink, 0, 0.5, width() - 28);
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
  double across_ = 0.0;  ///< of the next entry in a row of a legend below
};

}  // namespace

double legend_height(const FigureScales& scales, const FigureOptions& options) {
  constexpr double arrow = 62, mark = 42;
  return (by_material(options) ? materials_height(scales.materials.size()) : 0) +
         static_cast<double>(joint_entries(scales)) * line + (scales.fixed ? line : 0) +
         (scales.cracks ? line : 0) + (options.planes.empty() ? 0 : line) +
         (scales.water ? line : 0) + (options.arrows.empty() ? 0 : arrow) +
         bars(scales, options) * min_bar +
         mark * static_cast<double>(options.mark_names.size());
}

double legend_height_below(const FigureScales& scales, const FigureOptions& options,
                           double width) {
  const std::size_t materials = by_material(options) ? scales.materials.size() : 0;
  const std::size_t joints = joint_entries(scales);
  const std::size_t others = (scales.fixed ? 1 : 0) + (scales.cracks ? 1 : 0) +
                             (options.planes.empty() ? 0 : 1) + (scales.water ? 1 : 0);
  const auto rows = [&](std::size_t cells) {
    const double in_row = std::max(1.0, std::floor(width / cell));
    return std::ceil(static_cast<double>(cells) / in_row) * cell_line;
  };
  return (materials > few_materials
              ? rows(joints) + many_materials_height(materials, width) + rows(others)
              : rows(joints + materials + others)) +
         (options.arrows.empty() ? 0 : arrow_line) + bars(scales, options) * low_bar;
}

void draw_legend(Pen& pen, const LegendPlace& place, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options) {
  Legend(pen, place, picture, scales, options).draw();
}

}  // namespace blocks::post
