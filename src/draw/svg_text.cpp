#include "draw/svg_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "text/escaped.hpp"

namespace blocks::draw {
namespace {

const cairo_user_data_key_t collector{};

}  // namespace

SvgText::SvgText(cairo_surface_t* surface) : surface_(surface) {
  cairo_surface_set_user_data(surface, &collector, this, nullptr);
}

SvgText::~SvgText() {
  cairo_surface_set_user_data(surface_, &collector, nullptr, nullptr);
}

SvgText* SvgText::of(cairo_t* cairo) {
  return static_cast<SvgText*>(
      cairo_surface_get_user_data(cairo_get_target(cairo), &collector));
}

void SvgText::add(cairo_t* cairo, const TextLine& line) {
  if (line.words.empty() || cairo_in_clip(cairo, line.x, line.y) == 0)
    return;
  double x = line.x, y = line.y;
  cairo_user_to_device(cairo, &x, &y);
  cairo_matrix_t map;
  cairo_get_matrix(cairo, &map);
  const double scale = std::hypot(map.xx, map.yx);
  const double turn = std::atan2(map.yx, map.xx) * 180.0 / std::numbers::pi;
  elements_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" "
                           "text-anchor=\"{}\" fill=\"{}\"",
                           x, y, scale * line.size,
                           line.along == 0.0   ? "start"
                           : line.along == 1.0 ? "end"
                                               : "middle",
                           css(line.colour));
  if (turn != 0.0)
    elements_ += fmt::format(" transform=\"rotate({:.4g} {:.2f} {:.2f})\"", turn, x, y);
  if (line.rim > 0.0)
    elements_ += fmt::format(" stroke=\"{}\" stroke-width=\"{:.2f}\" "
                             "stroke-linejoin=\"round\" paint-order=\"stroke\"",
                             css(line.rim_colour), scale * line.rim);
  elements_ += ">" + text::escaped(line.words) + "</text>\n";
}

std::string SvgText::inserted(std::string page) const {
  const auto end = page.rfind("</svg>");
  if (end == std::string::npos)
    throw std::runtime_error("the SVG page has no end");
  page.insert(end, "<g font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" "
                   "xml:space=\"preserve\">\n" +
                       elements_ + "</g>\n");
  return page;
}

}  // namespace blocks::draw
