#include "joints/node_triangle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blocks::joints {
namespace {

using draw::Colour;
using geometry::Vec2;

constexpr Colour grid{0.82, 0.82, 0.83}, point{0.0, 0.32, 0.55};

class Triangle {
 public:
  Triangle(draw::Pen& pen, const draw::HistogramPlace& place)
      : pen_(pen), cairo_(pen.cairo()) {
    constexpr double aspect = 0.5 * std::numbers::sqrt3;  // height over side
    constexpr double names = 34;  // space for the names of the corners
    const double height = std::min(place.height, aspect * (place.width - names));
    const double side = height / aspect;
    const double middle =
        place.left + 0.5 * (place.width - draw::HistogramPlace::beside);
    i_ = {middle, place.top + 0.5 * (place.height - height)};
    y_ = {middle - 0.5 * side, i_.y() + height};
    x_ = {middle + 0.5 * side, i_.y() + height};
  }

  void frame() {
    for (const double c : {0.5, 1.0, 1.5, 1.8})
      contour(c);
    for (const Vec2& corner : {i_, y_, x_})
      cairo_line_to(cairo_, corner.x(), corner.y());
    cairo_close_path(cairo_);
    pen_.stroke(1.0, draw::ink);
    pen_.text("I", i_.x(), i_.y() - 6, 14, draw::ink, 0.5, 1);
    pen_.text("Y", y_.x() - 8, y_.y(), 14, draw::ink, 1, 0.5);
    pen_.text("X", x_.x() + 8, x_.y(), 14, draw::ink, 0, 0.5);
    pen_.text("nodes; lines: connections per branch", 0.5 * (y_.x() + x_.x()),
              y_.y() + 33, 14, draw::ink, 0.5, 0, 1.9 * (x_.x() - y_.x()));
  }

  void mark(const NodeCounts& nodes, const std::string& name, bool own) {
    const auto all = static_cast<double>(nodes.i + nodes.y + nodes.x);
    if (!(all > 0.0))
      return;
    const Vec2 p =
        at(static_cast<double>(nodes.i) / all, static_cast<double>(nodes.y) / all);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, p.x(), p.y(), 5.5, 0.0, 2.0 * std::numbers::pi);
    pen_.fill_and_stroke(own ? point : draw::white, 1.4, point);
    if (!name.empty())
      pen_.text(name, p.x() + 9, p.y(), 12.5, draw::ink, 0, 0.5);
  }

 private:
  /// The place of a network with these shares of I and Y nodes.
  Vec2 at(double i, double y) const { return i * i_ + y * y_ + (1.0 - i - y) * x_; }

  /// Draws where (3 Y + 4 X) (2 - c) = c I, a line from the side I-Y to the side I-X.
  void contour(double c) {
    const double on_y = 1.0 / (1.0 + c / (3.0 * (2.0 - c)));  // share of I there
    const double on_x = 1.0 / (1.0 + c / (4.0 * (2.0 - c)));
    const Vec2 left = at(on_y, 1.0 - on_y), right = at(on_x, 0.0);
    pen_.line(left.x(), left.y(), right.x(), right.y(), 0.8, grid);
    pen_.text(fmt::format("{:g}", c), right.x() + 6, right.y(), 12, draw::muted, 0,
              0.5);
  }

  draw::Pen& pen_;
  cairo_t* cairo_;
  Vec2 i_ = Vec2::Zero(), y_ = Vec2::Zero(), x_ = Vec2::Zero();  ///< corners
};

}  // namespace

void draw_node_triangle(draw::Pen& pen, const draw::HistogramPlace& place,
                        const std::vector<NodeCounts>& networks, std::size_t own) {
  Triangle triangle(pen, place);
  triangle.frame();
  for (std::size_t k = 0; k < networks.size(); ++k)
    if (k != own)
      triangle.mark(networks[k], fmt::format("{}", k + 1), false);
  triangle.mark(networks[own],
                networks.size() > 1 ? fmt::format("{}", own + 1) : std::string(), true);
}

}  // namespace blocks::joints
