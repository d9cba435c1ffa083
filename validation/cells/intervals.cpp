#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "validation/cells/figures.hpp"

namespace blocks::validation {
namespace {

using draw::Colour;

constexpr Colour grid{0.88, 0.88, 0.88}, band{0.92, 0.95, 0.98};
constexpr std::array<Colour, seed_sets> colours = {Colour{0.00, 0.36, 0.62},
                                                   {0.80, 0.33, 0.00}};
constexpr double page = 1200, head = 112, row_height = 26, group_height = 34, foot = 70;
constexpr double left = 470, right = 1160;

class IntervalDrawing {
 public:
  IntervalDrawing(cairo_t* cairo, const Study& study)
      : cairo_(cairo), pen_(cairo, draw::PageSize::on_screen(page)), study_(study) {
    for (const Row& row : study.rows)
      limit_ = std::max(limit_, study.limit(row, 0));
    max_ = std::ceil(limit_ + 0.5);
    for (const Row& row : study.rows)
      for (const Estimate& one : row.estimates)
        max_ = std::max(max_, std::ceil(std::abs(one.z(row.quantity.exact)) + 2.2));
  }

  static double height(const Study& study) {
    double result = head + foot;
    for (std::size_t i = 0; i < study.rows.size(); ++i)
      result += row_height + (is_first(study, i) ? group_height : 0.0);
    return result;
  }

  void draw() {
    const double bottom = height(study_) - foot;
    pen_.clear();
    pen_.text("Deviation of each mean from its exact value", 24, 34, 21, draw::ink, 0,
              1);
    pen_.text(
        "in standard errors, with 95 % intervals; shaded: 95 % of all means; dashed: "
        "limit of the test",
        24, 60, 15, draw::muted, 0, 1);
    cairo_rectangle(cairo_, x(-1.96), head, x(1.96) - x(-1.96), bottom - head);
    pen_.fill(band);
    for (int z = static_cast<int>(-max_); z <= static_cast<int>(max_); ++z) {
      pen_.line(x(z), head, x(z), bottom, z == 0 ? 1.6 : 1.0,
                z == 0 ? draw::muted : grid);
      pen_.text(fmt::format("{}", z), x(z), bottom + 11, 14, draw::ink, 0.5, 0);
    }
    pen_.dashes({6, 4});
    for (const double z : {-limit_, limit_})
      pen_.line(x(z), head, x(z), bottom, 1.6, draw::muted);
    pen_.dashes({});
    pen_.text("z", (left + right) / 2, bottom + 38, 15, draw::ink, 0.5, 0);
    draw_legend();
    double y = head;
    for (std::size_t i = 0; i < study_.rows.size(); ++i) {
      if (is_first(study_, i)) {
        pen_.line(24, y, right, y, 1.0, grid);
        pen_.text(study_.cases[study_.rows[i].index].group, 24,
                  y + group_height / 2 + 3, 15, draw::ink, 0, 0.5);
        y += group_height;
      }
      draw_row(study_.rows[i], y + row_height / 2);
      y += row_height;
    }
    pen_.line(24, y, right, y, 1.0, grid);
  }

 private:
  static bool is_first(const Study& study, std::size_t i) {
    const auto group = [&](std::size_t k) {
      return study.cases[study.rows[k].index].group;
    };
    return i == 0 || group(i) != group(i - 1);
  }
  double x(double z) const { return left + (z + max_) / (2 * max_) * (right - left); }
  void dot(double at, double y, std::size_t set) {
    cairo_arc(cairo_, at, y, 4, 0, 2 * std::numbers::pi);
    pen_.fill(colours[set]);
  }
  void draw_legend() {
    constexpr std::array names = {"first seeds", "second seeds"};
    for (std::size_t set = 0; set < seed_sets; ++set) {
      const double at = left + 140.0 * static_cast<double>(set);
      pen_.line(at, head - 20, at + 26, head - 20, 1.8, colours[set]);
      dot(at + 13, head - 20, set);
      pen_.text(names[set], at + 34, head - 20, 14, draw::ink, 0, 0.5);
    }
  }
  void draw_row(const Row& row, double y) {
    pen_.text(row.quantity.name, 44, y, 13.5, draw::ink, 0, 0.5, 150);
    pen_.text(study_.cases[row.index].name, 200, y, 13.5, draw::muted, 0, 0.5,
              left - 210);
    for (std::size_t set = 0; set < seed_sets; ++set) {
      const Estimate& one = row.estimates[set];
      const double at = y + (set == 0 ? -4.5 : 4.5), z = one.z(row.quantity.exact),
                   half = one.half_width(interval_level) / one.error;
      pen_.line(x(z - half), at, x(z + half), at, 1.8, colours[set]);
      dot(x(z), at, set);
    }
  }

  cairo_t* cairo_;
  draw::Pen pen_;
  const Study& study_;
  double limit_ = 0.0, max_ = 0.0;
};

}  // namespace

void draw_intervals(const Study& study, const std::string& path) {
  draw::write_page(path, page, IntervalDrawing::height(study),
                   [&](cairo_t* cairo) { IntervalDrawing(cairo, study).draw(); });
}

}  // namespace blocks::validation
