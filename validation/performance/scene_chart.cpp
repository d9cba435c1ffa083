// The chart shows phases of a step as bars and ratios of codes as marks.
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "compare_codes.hpp"
#include "draw/axes.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "scene_table.hpp"

namespace blocks::bench {
namespace {

using draw::Colour;

constexpr Colour grid{0.88, 0.88, 0.88};

struct Phase {
  const char* name;
  double Phases::*time;
  Colour colour;
};
constexpr std::array phases{Phase{"decisions", &Phases::decisions, {0.00, 0.36, 0.62}},
                            Phase{"forces", &Phases::forces, {0.43, 0.68, 0.86}},
                            Phase{"motion", &Phases::motion, {0.66, 0.73, 0.62}},
                            Phase{"search", &Phases::search, {0.85, 0.66, 0.25}}};

/// A code that is compared with the program, and the number of corners of its mark; 0
/// is a circle.
struct Other {
  const char* legend;
  const char* code;
  int threads;
  Colour colour;
  int corners;
};
constexpr std::array others{
    Other{"two threads", rigid_blocks, 2, {0.00, 0.51, 0.37}, 0},
    Other{"deformable", deformable_blocks, 1, {0.35, 0.35, 0.38}, 4},
    Other{"linked lists", linked_lists, 1, {0.80, 0.33, 0.00}, 3},
    Other{"Box2D 2.4.1", box2d_name, 1, {0.65, 0.25, 0.53}, 5}};

class SceneDrawing {
 public:
  static constexpr double head = 132, row_height = 38, foot = 62, page = 1200;

  static double height(std::size_t rows) {
    return head + row_height * static_cast<double>(rows) + foot;
  }

  SceneDrawing(cairo_t* cairo, double width, const Report& report,
               const std::vector<const Row*>& rows)
      : pen_(cairo, draw::PageSize::on_screen(width)), cairo_(cairo), report_(report),
        rows_(rows), bottom_(head + row_height * static_cast<double>(rows.size())) {
    std::vector<double> costs;
    for (const Row* row : rows)
      costs.push_back(row->cost);
    max_ = std::min(1.16 * *std::max_element(costs.begin(), costs.end()),
                    longest_bar * median(costs));
    for (const Row* row : rows)
      for (const Other& other : others)
        if (const Row* one = find(*row, other)) {
          min_ratio_ = std::min(min_ratio_, 0.8 * one->ratio->min);
          max_ratio_ = std::max(max_ratio_, 1.25 * one->ratio->max);
        }
  }

  void draw() {
    pen_.clear();
    pen_.text("Cost of a step, by scene and state", 24, 38, 21, draw::ink, 0, 1);
    pen_.text("one step of one block; Box2D: one of the eight iterations of a step", 24,
              64, 15, draw::muted, 0, 1);
    draw_panel(bars_left, bars_right, "nanoseconds of a rigid block, one thread");
    draw_panel(marks_left, marks_right,
               "cost over that of the program (left of 1: faster)");
    draw_bar_ticks();
    draw_mark_ticks();
    draw_legends();
    double y = head + row_height / 2;
    for (const Row* row : rows_) {
      draw_row(*row, y);
      y += row_height;
    }
  }

 private:
  static constexpr double bars_left = 330, bars_right = 700;
  static constexpr double marks_left = 750, marks_right = 1170;
  // Bars longer than this many medians are cut, so one slow scene does not hide others.
  static constexpr double longest_bar = 3.0;

  const Row* find(const Row& row, const Other& other) const {
    const Row* one = report_.find(row.scene, row.state, other.code, other.threads);
    return one != nullptr && one->ratio ? one : nullptr;
  }
  double bar_x(double ns) const {
    return bars_left + std::min(1.0, ns / max_) * (bars_right - bars_left);
  }
  double mark_x(double ratio) const {
    const double at = std::log(ratio / min_ratio_) / std::log(max_ratio_ / min_ratio_);
    return marks_left + at * (marks_right - marks_left);
  }

  void draw_panel(double left, double right, const char* label) {
    cairo_rectangle(cairo_, left, head, right - left, bottom_ - head);
    pen_.fill_and_stroke(draw::white, 1, grid);
    pen_.text(label, (left + right) / 2, bottom_ + 38, 14, draw::ink, 0.5, 0);
  }

  void draw_bar_ticks() {
    const auto ticks = draw::label_ticks(0.0, max_, 5);
    for (std::size_t i = 0; i < ticks.ticks.size(); ++i) {
      const double x = bar_x(ticks.ticks[i]);
      pen_.line(x, head, x, bottom_, 1, grid);
      pen_.text(ticks.labels[i], x, bottom_ + 11, 14, draw::ink, 0.5, 0);
    }
  }

  void draw_mark_ticks() {
    for (const double ratio :
         {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
      if (ratio < min_ratio_ || ratio > max_ratio_)
        continue;
      const double x = mark_x(ratio);
      pen_.line(x, head, x, bottom_, ratio == 1.0 ? 1.6 : 1,
                ratio == 1.0 ? draw::muted : grid);
      pen_.text(fmt::format("{:g}", ratio), x, bottom_ + 11, 14, draw::ink, 0.5, 0);
    }
  }

  void draw_legends() {
    constexpr double y = head - 22;
    double x = bars_left;
    for (const Phase& phase : phases) {
      cairo_rectangle(cairo_, x, y - 6, 12, 12);
      pen_.fill(phase.colour);
      pen_.text(phase.name, x + 18, y, 13, draw::ink, 0, 0.5);
      x += 94;
    }
    x = marks_left;
    for (const Other& other : others) {
      draw_mark(other, x + 6, y);
      pen_.text(other.legend, x + 18, y, 13, draw::ink, 0, 0.5);
      x += 108;
    }
  }

  void draw_mark(const Other& other, double x, double y) {
    constexpr double radius = 6;
    if (other.corners == 0)
      cairo_arc(cairo_, x, y, radius - 0.5, 0, 2 * std::numbers::pi);
    for (int k = 0; k < other.corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / other.corners;
      cairo_line_to(cairo_, x + radius * std::sin(angle), y - radius * std::cos(angle));
    }
    cairo_close_path(cairo_);
    pen_.fill_and_stroke(other.colour, 1, draw::white);
  }

  void draw_row(const Row& row, double y) {
    const bool first = &row == rows_.front() || row.scene != scene_;
    if (first && &row != rows_.front())
      pen_.line(24, y - row_height / 2, marks_right, y - row_height / 2, 1, grid);
    if (first)
      pen_.text(row.scene, 24, y, 14, draw::ink, 0, 0.5, 220);
    scene_ = row.scene;
    pen_.text(row.state, bars_left - 12, y, 14, draw::muted, 1, 0.5, 76);
    draw_bar(row, y);
    double at = y - 9;  // Ranges of different codes must not cover each other.
    for (const Other& other : others) {
      if (const Row* one = find(row, other)) {
        pen_.line(mark_x(one->ratio->min), at, mark_x(one->ratio->max), at, 2.4,
                  other.colour);
        draw_mark(other, mark_x(one->ratio->middle), at);
      }
      at += 6;
    }
  }

  /// The number is to the right of the bar, or inside a bar that is cut.
  void draw_bar(const Row& row, double y) {
    double from = 0.0;
    for (const Phase& phase : phases) {
      const double to = from + (*row.phases).*phase.time;
      cairo_rectangle(cairo_, bar_x(from), y - 11, bar_x(to) - bar_x(from), 22);
      pen_.fill(phase.colour);
      from = to;
    }
    const std::string time = short_number(row.cost);
    if (from <= max_) {
      pen_.text(time, bar_x(from) + 6, y, 13, draw::ink, 0, 0.5);
      return;
    }
    pen_.line(bars_right - 66, y + 14, bars_right - 56, y - 14, 6, draw::white);
    pen_.text(time, bars_right - 8, y, 13, draw::white, 1, 0.5);
  }

  draw::Pen pen_;
  cairo_t* cairo_;
  const Report& report_;
  const std::vector<const Row*>& rows_;
  double bottom_;
  double max_ = 0.0;  ///< end of the axis of the bars, nanoseconds
  double min_ratio_ = 0.4, max_ratio_ = 12.0;
  std::string scene_;  ///< scene of the row above
};

}  // namespace

bool draw_scenes(const Report& report, const std::string& path) {
  std::vector<const Row*> rows;
  for (const Row& row : report.rows)
    if (row.phases)
      rows.push_back(&row);
  if (rows.empty())
    return false;
  constexpr double width = 1200;
  const double height = SceneDrawing::height(rows.size()) * width / SceneDrawing::page;
  draw::write_page(path, width, height, [&](cairo_t* cairo) {
    SceneDrawing(cairo, width, report, rows).draw();
  });
  return true;
}

}  // namespace blocks::bench
