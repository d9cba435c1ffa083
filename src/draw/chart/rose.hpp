// The rose diagram of directions, of joints or cracks, and its legend.
#pragma once

#include <functional>
#include <string>

#include "draw/chart/directions.hpp"
#include "draw/pen.hpp"

namespace blocks::draw {

/// The half disc of a rose on the page [units]: the middle of its base, and its radius.
struct RosePlace {
  double x, y, radius;
  /// The space that its numbers need beside, above and below the half disc.
  static constexpr double beside = 50, above = 40, below = 66;
};

/// Draws the directions from 0 (right) to 180 degrees (left). The area of a sector is
/// proportional to the length of its sides; the groups are stacked in the order of
/// their ids.
void draw_rose(Pen& pen, const RosePlace& place, const Directions& directions);

/// Returns the height of the legend.
double rose_legend_height(const Directions& directions);

/// Draws colour, name, share, mean direction and deviation of each group. name_of(id)
/// is "joint 3" or "cracks by stress".
void draw_rose_legend(Pen& pen, double x, double top, double width,
                      const Directions& directions,
                      const std::function<std::string(int)>& name_of);

}  // namespace blocks::draw
