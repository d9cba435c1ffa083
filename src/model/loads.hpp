// Loads: the time function, pressures on sides and forces at centroids (report A.1.8,
// A.2.10, A.2.11).
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

/// FUNCTION: a piecewise linear function of time, constant beyond its ends.
struct TimeFunction {
  std::vector<double> t;  ///< [T] increasing
  std::vector<double> p;  ///< factor

  bool empty() const { return t.empty(); }
  /// Returns 0 before the arrival time, then the function of the time since arrival
  /// (docs/theory.md#pressure-and-forces).
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
  double arrival = 0;             ///< [T]
};

/// DRIVE: the motion of a fixed block.
struct Drive {
  int block = 0;                     ///< from 0
  geometry::Vec2 velocity = {0, 0};  ///< [L/T] of the centroid
  double spin = 0.0;                 ///< rad/T, anticlockwise
};

struct Loads {
  TimeFunction function;
  std::vector<Pressure> pressures;
  std::vector<CentroidForce> forces;

  bool none() const { return pressures.empty() && forces.empty(); }
};

}  // namespace blocks
