// Curves of drawings as chords. Only square roots and the four operations are used, so
// the chords are the same on every machine. Private to src/exchange.
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::exchange {

/// The distance of chords from their curve, [L].
struct ChordError {
  double allowed = 0.0;
  double largest = 0.0;  ///< a bound of what was made; each function raises it
};

/// Returns the point of the unit circle at an angle in degrees; exact at multiples of
/// 90.
geometry::Vec2 unit_vector(double degrees);

/// Appends the ends of the chords of an arc from p to q, without p. bulge: the tangent
/// of a quarter of the angle of the arc, positive anticlockwise; 0 is a straight line.
void add_arc(const geometry::Vec2& p, const geometry::Vec2& q, double bulge,
             ChordError& error, std::vector<geometry::Vec2>& points);

/// Returns the ends of the chords of an arc of the unit circle, anticlockwise from an
/// angle. turn: in degrees, > 0 to 360; of a whole turn the last point is the first.
std::vector<geometry::Vec2> unit_arc(double from, double turn, ChordError& error);

/// A B-spline with weights (NURBS).
struct Spline {
  int degree = 3;                      ///< 1 to 25
  std::vector<double> knots;           ///< not decreasing, points + degree + 1
  std::vector<geometry::Vec2> points;  ///< [L] control points, at least degree + 1
  std::vector<double> weights;         ///< > 0, one per control point
};

/// Returns what is wrong with the spline; empty if nothing is.
const char* fault_of(const Spline& spline);

/// Returns the ends of the chords of a spline without fault. A curve is within the hull
/// of its control points, so their distance from the chord bounds the error.
std::vector<geometry::Vec2> spline_chords(const Spline& spline, ChordError& error);

}  // namespace blocks::exchange
