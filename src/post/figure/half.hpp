// Where a half of a picture is on the page: the model itself, or its mirror image.
#pragma once

#include <cairo.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "draw/axes.hpp"

namespace blocks::post {

struct Half {
  const draw::Axes& axes;
  /// [L] The symmetry plane x = mirror_x of the mirror image; none: the model itself.
  std::optional<double> mirror_x;

  /// Returns the place of a point of the model on the page.
  Eigen::Vector2d at(const Eigen::Vector2d& p) const {
    return {axes.x(mirror_x ? 2.0 * *mirror_x - p.x() : p.x()), axes.y(p.y())};
  }
  /// Returns the box around an outline on the page.
  Eigen::AlignedBox2d box(const std::vector<Eigen::Vector2d>& outline) const {
    Eigen::AlignedBox2d found;
    for (const Eigen::Vector2d& p : outline)
      found.extend(at(p));
    return found;
  }
  /// Adds the line between two points of the model to the path, unless it is outside of
  /// the plot. Returns whether it is added.
  bool trace(cairo_t* cairo, const Eigen::Vector2d& from,
             const Eigen::Vector2d& to) const {
    constexpr double margin = 5.0;  // more than half of a line
    const Eigen::Vector2d a = at(from), b = at(to);
    const Eigen::Vector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
    if (high.x() < axes.left - margin || low.x() > axes.right() + margin ||
        high.y() < axes.top - margin || low.y() > axes.bottom() + margin)
      return false;
    cairo_move_to(cairo, a.x(), a.y());
    cairo_line_to(cairo, b.x(), b.y());
    return true;
  }
};

}  // namespace blocks::post
