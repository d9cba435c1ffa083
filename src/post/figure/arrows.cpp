#include "post/figure/arrows.hpp"

#include <algorithm>
#include <cmath>

#include "post/figure/half.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using Vector = Eigen::Vector2d;
constexpr double longest_head = 9.0, min_open = 7.0;  // [page units]

/// An arrow on the page.
struct Arrow {
  Vector from, to;
  bool is_cut = false;  ///< the arrow goes on
};

/// Returns the length of the head of an arrow.
double head_of(const Arrow& arrow) {
  return std::min(0.4 * (arrow.to - arrow.from).norm(), longest_head);
}

/// Draws an arrow with a rim, which is visible on dark blocks too. A cut arrow has an
/// open head.
void put(Pen& pen, const Arrow& arrow, const Vector& along, double head) {
  cairo_t* cairo = pen.cairo();
  const double length = (arrow.to - arrow.from).norm();
  const Vector base = arrow.to - head * along,
               side = 0.42 * head * Vector(-along.y(), along.x());
  const auto shaft = [&] {
    if (length <= head)
      return;
    cairo_move_to(cairo, arrow.from.x(), arrow.from.y());
    cairo_line_to(cairo, base.x(), base.y());
  };
  const auto triangle = [&] {
    cairo_move_to(cairo, arrow.to.x(), arrow.to.y());
    cairo_line_to(cairo, base.x() + side.x(), base.y() + side.y());
    cairo_line_to(cairo, base.x() - side.x(), base.y() - side.y());
    cairo_close_path(cairo);
  };
  shaft(), triangle();
  pen.stroke(3.2, white, 0.75);
  shaft();
  pen.stroke(1.3, ink);
  triangle();
  if (arrow.is_cut)
    pen.fill_and_stroke(white, 1.1, ink);
  else
    pen.fill(ink);
}

/// Returns the part of an arrow inside a box, whose corners are low and high; empty if
/// there is none.
std::optional<Arrow> inside(const Arrow& arrow, const Vector& low, const Vector& high) {
  const Vector way = arrow.to - arrow.from;
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0.0) {
      if (arrow.from[axis] < low[axis] || arrow.from[axis] > high[axis])
        return std::nullopt;
      continue;
    }
    const double a = (low[axis] - arrow.from[axis]) / way[axis],
                 b = (high[axis] - arrow.from[axis]) / way[axis];
    begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
  }
  if (!(begin < end))
    return std::nullopt;
  return Arrow{arrow.from + begin * way, arrow.from + end * way, end < 1.0};
}

}  // namespace

void draw_arrow(Pen& pen, double x, double y, double dx, double dy) {
  const Vector from(x, y), way(dx, dy);
  const Arrow arrow{from, from + way};
  put(pen, arrow, way.normalized(), head_of(arrow));
}

void draw_arrows(Pen& pen, const Half& half, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options) {
  if (!(scales.arrow > 0.0))
    return;
  constexpr double shortest = 1.5, to_frame = 2.0;
  const Axes& axes = half.axes;
  const Vector low(axes.left + to_frame, axes.top + to_frame),
      high(axes.right() - to_frame, axes.bottom() - to_frame);
  const Frame& now = picture.now;
  const Eigen::AlignedBox2d plot(low, high);
  const Eigen::Matrix2Xd vectors = arrow_vectors(options.arrows, picture);
  const double full = arrow_length(axes, scales), factor = full / scales.arrow;
  std::vector<Arrow> arrows;
  for (int b = 0; b < now.size(); ++b) {
    Vector way = factor * vectors.col(b);
    if (scales.cuts_arrows && way.norm() > full)
      way *= full / way.norm();
    if (!(way.norm() >= shortest) ||
        !half.box(now.outlines[static_cast<std::size_t>(b)]).intersects(plot))
      continue;
    const Vector from = half.at(now.centroid.col(b));
    arrows.push_back(
        {from, from + Vector(half.mirror_x ? -way.x() : way.x(), -way.y())});
  }
  std::stable_sort(arrows.begin(), arrows.end(), [](const Arrow& a, const Arrow& b) {
    return (a.to - a.from).squaredNorm() > (b.to - b.from).squaredNorm();
  });
  for (const Arrow& arrow : arrows) {
    const auto part = inside(arrow, low, high);
    const double head = head_of(arrow);
    // The open head of an arrow that leaves is seen however little of it is left.
    if (part && part->is_cut)
      put(pen, *part, (arrow.to - arrow.from).normalized(), std::max(head, min_open));
    else if (part && (part->to - part->from).norm() >= head)
      put(pen, *part, (arrow.to - arrow.from).normalized(), head);
  }
}

double arrow_length(const Axes& axes, const FigureScales& scales) {
  return scales.on_page(axes, 1.8, 24.0, 90.0);
}

}  // namespace blocks::post
