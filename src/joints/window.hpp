// What a window shows of lines of one direction: its area, its width, and its chords.
#pragma once

#include <utility>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::joints {

/// Returns the unit vector of a direction in degrees from the x axis.
geometry::Vec2 unit_vector(double degrees);

/// Integrals over the chords c of a window in one direction, with dt across them.
struct ChordMeasure {
  double area = 0.0;   ///< [L^2] of max(c - shortest, 0) dt
  double width = 0.0;  ///< [L] of dt, over chords with c >= shortest
};

/// Integrates exactly. window: a simple polygon, [L], of any orientation. degrees:
/// direction of the chords. shortest: [L] >= 0; with 0 the result is the area, and for
/// a convex window its width across the direction. A concave window has several chords
/// on one line, which count separately.
ChordMeasure chord_measure(const geometry::Polygon& window, double degrees,
                           double shortest = 0.0);

/// Returns the parts of the line from + s * along that are inside the window, as
/// intervals of s in ascending order.
std::vector<std::pair<double, double>> chords(const geometry::Polygon& window,
                                              const geometry::Vec2& from,
                                              const geometry::Vec2& along);

}  // namespace blocks::joints
