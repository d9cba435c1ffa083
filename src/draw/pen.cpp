#include "draw/pen.hpp"

#include <algorithm>
#include <numbers>

namespace blocks::draw {

Pen::Pen(cairo_t* cairo, const PageSize& page) : cairo_(cairo), page_(page) {
  cairo_scale(cairo_, page.unit, page.unit);
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_font_options_t* fonts = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(fonts, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo_, fonts);  // text widths scale exactly with the size
  cairo_font_options_destroy(fonts);
}

void Pen::colour(const Colour& c, double alpha) {
  cairo_set_source_rgba(cairo_, c.r, c.g, c.b, alpha);
}

void Pen::clear() {
  colour(paper);
  cairo_paint(cairo_);
}

void Pen::fill(const Colour& c, double alpha) {
  colour(c, alpha);
  cairo_fill(cairo_);
}

void Pen::stroke(double width, const Colour& c, double alpha) {
  cairo_set_line_width(cairo_, width);
  colour(c, alpha);
  cairo_stroke(cairo_);
}

void Pen::fill_and_stroke(const Colour& inside, double width, const Colour& outline) {
  colour(inside);
  cairo_fill_preserve(cairo_);
  stroke(width, outline);
}

void Pen::line(double x0, double y0, double x1, double y1, double width,
               const Colour& c, double alpha) {
  cairo_move_to(cairo_, x0, y0);
  cairo_line_to(cairo_, x1, y1);
  stroke(width, c, alpha);
}

void Pen::dashes(std::initializer_list<double> lengths) {
  cairo_set_dash(cairo_, lengths.begin(), static_cast<int>(lengths.size()), 0);
}

double Pen::letters(double size) const {
  return std::clamp(size, page_.min_text, page_.max_text);
}

cairo_text_extents_t Pen::measure(const std::string& words, double size) {
  cairo_text_extents_t box;
  cairo_set_font_size(cairo_, letters(size));
  cairo_text_extents(cairo_, words.c_str(), &box);
  return box;
}

/// Returns the text, cut and with an ellipsis if it is longer than `width`.
std::string Pen::fitted(std::string words, double size, double width) {
  constexpr double rounding = 1e-6;
  if (measure(words, size).width <= width * (1.0 + rounding))
    return words;
  const auto inside_letter = [](char byte) {  // of UTF-8
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
  };
  while (!words.empty() && measure(words + "…", size).width > width) {
    while (words.size() > 1 && inside_letter(words.back()))
      words.pop_back();
    words.pop_back();
  }
  return words + "…";
}

/// Draws a line of text with cairo or as an SVG element.
void Pen::put(const TextLine& line) {
  if (SvgText* svg = SvgText::of(cairo_)) {
    svg->add(cairo_, line);
    return;
  }
  const cairo_text_extents_t box = measure(line.words, line.size);
  cairo_move_to(cairo_, line.x - box.x_bearing - line.along * box.width, line.y);
  if (line.rim > 0.0) {
    cairo_text_path(cairo_, line.words.c_str());
    stroke(line.rim, line.rim_colour, 0.85);
    cairo_move_to(cairo_, line.x - box.x_bearing - line.along * box.width, line.y);
  }
  colour(line.colour);
  cairo_show_text(cairo_, line.words.c_str());
  cairo_new_path(cairo_);
}

void Pen::text(const std::string& given, double x, double y, double size,
               const Colour& c, double along, double up, double width) {
  const std::string words = with_minus_signs(given);
  cairo_text_extents_t box = measure(words, size);
  std::string shown = words;
  if (box.width > width) {
    size = letters(size) * width / box.width;
    if (size < page_.min_text)
      shown = fitted(words, size, width);
    box = measure(shown, size);
  }
  put({shown, x, y - box.y_bearing - up * box.height, along, letters(size), c, 0, {}});
}

void Pen::text_on_line(const std::string& words, double x, double y, double size,
                       const Colour& c) {
  put({with_minus_signs(words), x, y, 0, letters(size), c, 0, {}});
}

double Pen::paragraph(const std::string& words, double x, double y, double size,
                      const Colour& c, double width) {
  const double step = 1.25 * letters(size);
  const double from = y;
  std::string line;
  const auto put = [&] {
    text(line, x, y + 0.5 * size, size, c, 0, 0.5, width);
    y += step;
  };
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end =
        words[at] == '[' ? words.size() : std::min(words.find(' ', at), words.size());
    const std::string word = words.substr(at, end - at);
    std::string longer = line;
    longer += line.empty() ? "" : " ";
    longer += word;
    if (!line.empty() && measure(longer, size).width > width) {
      put();
      line = word;
    } else {
      line = longer;
    }
    at = end + 1;
  }
  put();
  return y - from;
}

void Pen::label(const std::string& words, double x, double y, double size,
                const Colour& c, const Colour& ground) {
  const cairo_text_extents_t box = measure(words, size);
  put({words, x, y - box.y_bearing - 0.5 * box.height, 0.5, letters(size), c,
       0.3 * letters(size), ground});
}

void Pen::upright(const std::string& words, double x, double y, double size,
                  const Colour& c, double width) {
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  cairo_rotate(cairo_, -std::numbers::pi / 2);
  text(words, 0, 0, size, c, 0.5, 0.5, width);
  cairo_restore(cairo_);
}

void Pen::tag(const std::string& words, double x, double y, const Colour& c) {
  constexpr double size = 13, edge = 4;
  const cairo_text_extents_t box = measure(words, size);
  cairo_rectangle(cairo_, x - edge, y - 0.5 * box.height - edge, box.width + 2 * edge,
                  box.height + 2 * edge);
  fill(paper, 0.85);
  text(words, x, y, size, c, 0, 0.5);
}

}  // namespace blocks::draw
