#include "study/figure.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/colour_map.hpp"
#include "draw/page_file.hpp"

namespace blocks::study {
namespace {

using draw::Colour;

constexpr Colour ink{0.16, 0.16, 0.18}, faint{0.62, 0.62, 0.64},
    paper{0.992, 0.99, 0.984};
constexpr Colour hang{0.03, 0.38, 0.72}, fall{0.84, 0.27, 0.0}, ghost{0.86, 0.86, 0.89};
constexpr double line = 17, label = 112, gap = 26, head = 44, foot = 34, top = 76;
constexpr double title = 16, small = 11;  // font sizes
constexpr std::size_t columns = 3;

class Sheet {
 public:
  Sheet(cairo_t* pen, double width) : pen_(pen), width_(width) {}

  void draw(const std::vector<Study>& studies) {
    cairo_select_font_face(pen_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    colour(paper);
    cairo_paint(pen_);
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
    std::size_t most = 0;
    for (const Study& study : studies)
      most = std::max(most, study.rows.size());
    return head + line * static_cast<double>(most) + foot;
  }

 private:
  void colour(const Colour& c) { cairo_set_source_rgb(pen_, c.r, c.g, c.b); }
  /// `along` and `up` select the point of the text box that is at (x, y). (0, 0) is the
  /// top left, (1, 1) the bottom right.
  void text(const std::string& words, double x, double y, double size, const Colour& c,
            double along, double up) {
    cairo_set_font_size(pen_, size);
    cairo_text_extents_t box;
    cairo_text_extents(pen_, words.c_str(), &box);
    colour(c);
    cairo_move_to(pen_, x - box.x_bearing - along * box.width,
                  y - box.y_bearing - up * box.height);
    cairo_show_text(pen_, words.c_str());
    cairo_new_path(pen_);
  }

  void draw_panel(const Study& study, double x, double y, double w) {
    heading(study, x, y, w);
    const double first = y + head - line / 2;
    const double bottom = y + head + line * static_cast<double>(study.rows.size());
    colour({1, 1, 1});
    cairo_rectangle(pen_, x, first, w, bottom - line / 2 - first);
    cairo_fill(pen_);
    for (int k = 0; k <= 4; ++k) {
      const double at = x + w * k / 4.0;
      colour({0.9, 0.9, 0.9});
      cairo_set_line_width(pen_, 1);
      cairo_move_to(pen_, at, first);
      cairo_line_to(pen_, at, bottom - line / 2);
      cairo_stroke(pen_);
      text(fmt::format("{}", 25 * k), at, bottom, 11, faint, 0.5, 0);
    }
    double row_y = y + head;
    for (const Row& row : study.rows) {
      text(std::string(row.variant->name), x - 8, row_y, 12.5, ink, 1, 0.5);
      if (!row.refused.empty())
        text("not run", x + 8, row_y, 11, faint, 0, 0.5);
      if (row.phantom.value > 0.0) {
        colour(ghost);
        cairo_rectangle(pen_, x, row_y - 0.4 * line, w * row.phantom.value, 0.8 * line);
        cairo_fill(pen_);
      }
      interval(row.hang_ups, x, row_y - 3.2, w, hang, false);
      interval(row.fall_throughs, x, row_y + 3.2, w, fall, true);
      row_y += line;
    }
    colour(ink);
    cairo_set_line_width(pen_, 1);
    cairo_rectangle(pen_, x, first, w, bottom - line / 2 - first);
    cairo_stroke(pen_);
  }

  double width_of(const std::string& words, double size) {
    cairo_set_font_size(pen_, size);
    cairo_text_extents_t box;
    cairo_text_extents(pen_, words.c_str(), &box);
    return box.x_advance;
  }

  /// Draws words on a base line, independent of the heights of their letters.
  void line_of(const std::string& words, double x, double y, double size,
               const Colour& c) {
    cairo_set_font_size(pen_, size);
    colour(c);
    cairo_move_to(pen_, x, y);
    cairo_show_text(pen_, words.c_str());
    cairo_new_path(pen_);
  }

  /// Whether the scene's name and the remark do not fit on one line of this width.
  bool collides(const Study& study, double w) {
    const std::string note = remark(study);
    return !note.empty() &&
           width_of(study.scene, title) + small + width_of(note, small) > w;
  }

  /// Draws the scene's name. The remark is beside it or, if one is too long in any
  /// panel, below it.
  void heading(const Study& study, double x, double y, double w) {
    std::string name = study.scene;
    while (width_of(name, title) > w) {  // the end of a path is more informative
      std::size_t cut = name.starts_with("…") ? std::string("…").size() : 0;
      do
        ++cut;
      while (cut < name.size() && (name[cut] & 0xC0) == 0x80);
      name = "…" + name.substr(cut);
    }
    const std::string note = remark(study);
    line_of(name, x, below_ ? y + 14 : y + 22, title, ink);
    line_of(note, below_ ? x : x + w - width_of(note, small), below_ ? y + 29 : y + 22,
            small, faint);
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
    colour(c);
    cairo_set_line_width(pen_, 1.6);
    cairo_move_to(pen_, x + w * e.low, y);
    cairo_line_to(pen_, x + w * e.high, y);
    cairo_stroke(pen_);
    const double at = x + w * e.value;
    if (diamond) {
      for (int k = 0; k < 4; ++k)
        cairo_line_to(pen_, at + 3.6 * std::cos(k * std::numbers::pi / 2),
                      y + 3.6 * std::sin(k * std::numbers::pi / 2));
      cairo_close_path(pen_);
    } else {
      cairo_arc(pen_, at, y, 3.2, 0, 2 * std::numbers::pi);
    }
    cairo_fill(pen_);
  }

  void legend(const std::vector<Study>& studies) {
    text("Contact rules in random frames", gap, 30, 20, ink, 0, 1);
    int frames = 0;
    for (const Study& study : studies)
      for (const Row& row : study.rows)
        frames = std::max(frames, row.frames);
    text(fmt::format("per cent of {} frame{}, 95 % confidence", frames,
                     frames == 1 ? "" : "s"),
         gap, 54, 13.5, {0.36, 0.36, 0.4}, 0, 1);
    double x = width_ > 900 ? 0.42 * width_ : gap + 300;
    const double y = 48;
    interval({0.5, 0.0, 1.0}, x, y, 26, hang, false);
    text("hang-ups", x + 34, y, 13.5, ink, 0, 0.5);
    x += 120;
    interval({0.5, 0.0, 1.0}, x, y, 26, fall, true);
    text("fall-throughs", x + 34, y, 13.5, ink, 0, 0.5);
    x += 150;
    colour(ghost);
    cairo_rectangle(pen_, x, y - 0.4 * line, 26, 0.8 * line);
    cairo_fill(pen_);
    text("phantom contacts, % of those acting", x + 34, y, 13.5, ink, 0, 0.5);
  }

  cairo_t* pen_;
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
                   [&](cairo_t* pen) { Sheet(pen, width).draw(studies); });
}

}  // namespace blocks::study
