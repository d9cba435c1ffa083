#include "study/figure.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/page_file.hpp"
#include "draw/pen.hpp"

namespace blocks::study {
namespace {

using draw::Colour;

using draw::faint, draw::ink;

constexpr Colour paper{0.992, 0.99, 0.984}, grid{0.9, 0.9, 0.9};
constexpr Colour hang{0.03, 0.38, 0.72}, fall{0.84, 0.27, 0.0}, ghost{0.86, 0.86, 0.89};
constexpr double line = 17, label = 112, gap = 26, head = 44, foot = 34, top = 76;
constexpr double title = 16, small = 11;  // font sizes
constexpr std::size_t columns = 3;

class Sheet {
 public:
  Sheet(cairo_t* cairo, double width)
      : pen_(cairo, draw::PageSize()), cairo_(cairo), width_(width) {}

  void draw(const std::vector<Study>& studies) {
    pen_.colour(paper);
    cairo_paint(cairo_);
    legend(studies);
    const std::size_t across = std::min(columns, studies.size());
    const double panel = (width_ - 2 * gap) / static_cast<double>(across);
    below_ = std::any_of(studies.begin(), studies.end(), [&](const Study& study) {
      return collides(study, panel - label - gap);
    });
    for (std::size_t i = 0; i < studies.size(); ++i) {
      const double x = gap + panel * static_cast<double>(i % across) + label;
      const double y = top + panel_height(studies) * static_cast<double>(i / across);
      draw_panel(studies[i], x, y, panel - label - gap);
    }
  }

  static double panel_height(const std::vector<Study>& studies) {
    std::size_t max = 0;
    for (const Study& study : studies)
      max = std::max(max, study.rows.size());
    return head + line * static_cast<double>(max) + foot;
  }

 private:
  void draw_panel(const Study& study, double x, double y, double w) {
    heading(study, x, y, w);
    const double first = y + head - line / 2;
    const double bottom = y + head + line * static_cast<double>(study.rows.size());
    cairo_rectangle(cairo_, x, first, w, bottom - line / 2 - first);
    pen_.fill(draw::white);
    for (int k = 0; k <= 4; ++k) {
      const double at = x + w * k / 4.0;
      pen_.line(at, first, at, bottom - line / 2, 1.0, grid);
      pen_.text(fmt::format("{}", 25 * k), at, bottom, 11, faint, 0.5, 0);
    }
    double row_y = y + head;
    for (const Row& row : study.rows) {
      pen_.text(std::string(row.variant->name), x - 8, row_y, 12.5, ink, 1, 0.5);
      if (!row.refused.empty())
        pen_.text("not run", x + 8, row_y, 11, faint, 0, 0.5);
      if (row.phantom.value > 0.0) {
        cairo_rectangle(cairo_, x, row_y - 0.4 * line, w * row.phantom.value,
                        0.8 * line);
        pen_.fill(ghost);
      }
      interval(row.hang_ups, x, row_y - 3.2, w, hang, false);
      interval(row.fall_throughs, x, row_y + 3.2, w, fall, true);
      row_y += line;
    }
    cairo_rectangle(cairo_, x, first, w, bottom - line / 2 - first);
    pen_.stroke(1.0, ink);
  }

  /// Whether the scene's name and the remark do not fit on one line of this width.
  bool collides(const Study& study, double w) {
    const std::string note = remark(study);
    return !note.empty() &&
           pen_.width(study.scene, title) + small + pen_.width(note, small) > w;
  }

  /// Draws the scene's name. The remark is beside it or, if one is too long in any
  /// panel, below it.
  void heading(const Study& study, double x, double y, double w) {
    std::string name = study.scene;
    while (pen_.width(name, title) > w) {  // the end of a path is more informative
      std::size_t cut = name.starts_with("…") ? std::string("…").size() : 0;
      do
        ++cut;
      while (cut < name.size() && (name[cut] & 0xC0) == 0x80);
      name = "…" + name.substr(cut);
    }
    const std::string note = remark(study);
    pen_.text_on_line(name, x, below_ ? y + 14 : y + 22, title, ink);
    pen_.text_on_line(note, below_ ? x : x + w - pen_.width(note, small),
                      below_ ? y + 29 : y + 22, small, faint);
  }

  /// The reason why a panel has no marks of some kind.
  static std::string remark(const Study& study) {
    if (study.rows.empty())
      return "not run";
    const bool moves =
        std::any_of(study.rows.begin(), study.rows.end(),
                    [](const Row& row) { return !std::isnan(row.hang_ups.value); });
    return moves ? "" : "nothing moves, so nothing can hang";
  }

  void interval(const Estimate& e, double x, double y, double w, const Colour& c,
                bool diamond) {
    if (std::isnan(e.value))
      return;
    pen_.line(x + w * e.low, y, x + w * e.high, y, 1.6, c);
    const double at = x + w * e.value;
    if (diamond) {
      for (int k = 0; k < 4; ++k)
        cairo_line_to(cairo_, at + 3.6 * std::cos(k * std::numbers::pi / 2),
                      y + 3.6 * std::sin(k * std::numbers::pi / 2));
      cairo_close_path(cairo_);
    } else {
      cairo_arc(cairo_, at, y, 3.2, 0, 2 * std::numbers::pi);
    }
    pen_.fill(c);
  }

  void legend(const std::vector<Study>& studies) {
    pen_.text("Contact rules in random frames", gap, 30, 20, ink, 0, 1);
    int frames = 0;
    for (const Study& study : studies)
      for (const Row& row : study.rows)
        frames = std::max(frames, row.frames);
    pen_.text(fmt::format("per cent of {} frame{}, 95 % confidence", frames,
                          frames == 1 ? "" : "s"),
              gap, 54, 13.5, draw::muted, 0, 1);
    double x = width_ > 900 ? 0.42 * width_ : gap + 300;
    const double y = 48;
    interval({0.5, 0.0, 1.0}, x, y, 26, hang, false);
    pen_.text("hang-ups", x + 34, y, 13.5, ink, 0, 0.5);
    x += 120;
    interval({0.5, 0.0, 1.0}, x, y, 26, fall, true);
    pen_.text("fall-throughs", x + 34, y, 13.5, ink, 0, 0.5);
    x += 150;
    cairo_rectangle(cairo_, x, y - 0.4 * line, 26, 0.8 * line);
    pen_.fill(ghost);
    pen_.text("phantom contacts, % of those acting", x + 34, y, 13.5, ink, 0, 0.5);
  }

  draw::Pen pen_;
  cairo_t* cairo_;
  double width_;
  bool below_ = false;  ///< remarks are below the names
};

}  // namespace

void draw_studies(const std::string& path, const std::vector<Study>& studies) {
  const std::size_t across = std::min(columns, studies.size());
  const std::size_t down = (studies.size() + across - 1) / across;
  const double width = across == 1 ? 900 : 400 * static_cast<double>(across);
  const double height =
      top + Sheet::panel_height(studies) * static_cast<double>(down) + 8;
  draw::write_page(path, width, height,
                   [&](cairo_t* cairo) { Sheet(cairo, width).draw(studies); });
}

}  // namespace blocks::study
