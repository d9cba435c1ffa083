// Loads: the time function, pressures on sides, forces at centroids (report A.1.8,
// A.2.10, A.2.11) and water.
#pragma once

#include <limits>
#include <vector>

#include "geometry/vec2.hpp"
#include "model/water.hpp"

namespace blocks {

/// FUNCTION: a piecewise linear function of time, constant beyond its ends.
struct TimeFunction {
  std::vector<double> t;  ///< [T] not decreasing; equal times make a step
  std::vector<double> p;  ///< factor

  /// The arrival time of loads that act at all times and are not multiplied by the
  /// function.
  static constexpr double always = std::numeric_limits<double>::lowest();

  bool empty() const { return t.empty(); }
  /// Returns 0 before the arrival time, then the function of the time since arrival
  /// (docs/theory.md#pressure-and-forces). At a step it returns the later value.
  /// Returns 1 if the arrival is `always`.
  double factor(double time, double arrival) const;
};

/// PRESSBC: a pressure that varies linearly from p1 at the first corner of a side to p2
/// at the second. Positive pressure pushes inwards.
struct Pressure {
  int block = 0, side = 0;  ///< from 0
  double p1 = 0, p2 = 0;    ///< [F/L^2] multiplied by the time function
  double arrival = 0;       ///< [T]
};

/// FORCE: a force at the centroid of a block.
struct CentroidForce {
  int block = 0;
  geometry::Vec2 force = {0, 0};  ///< [F] multiplied by the time function
  double arrival = 0;             ///< [T], or TimeFunction::always

  bool is_constant() const { return arrival == TimeFunction::always; }
};

/// DRIVE: the motion of a fixed block.
struct Drive {
  int block = 0;                     ///< from 0
  geometry::Vec2 velocity = {0, 0};  ///< [L/T] of the centroid
  double spin = 0.0;                 ///< rad/T, anticlockwise
};

/// SERVO: a driven block whose velocity follows from the stress on one of its sides.
struct Servo {
  int block = 0, side = 0;  ///< from 0
  double target = 0.0;      ///< [F/L^2] normal stress, tension positive
  double max_speed = 0.0;   ///< [L/T] largest speed > 0
};

/// QUIET: dashpots and constant forces at the two corners of a side of a free block.
struct QuietSide {
  int block = 0, side = 0;    ///< from 0
  double cp = 0.0, cs = 0.0;  ///< [L/T] wave speeds
  /// [F] the reaction that held the side when it became quiet, at the corner where the
  /// side begins and at the next one
  geometry::Vec2 first = {0, 0}, second = {0, 0};
};

struct Loads {
  TimeFunction function;
  std::vector<Pressure> pressures;
  std::vector<CentroidForce> forces;
  std::vector<QuietSide> quiet_sides;
  Water water;

  bool none() const {
    return pressures.empty() && forces.empty() && quiet_sides.empty() && water.none();
  }
};

}  // namespace blocks
