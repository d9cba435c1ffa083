// This header lists the scenes of the benchmark, each in the state in which it is
// timed.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks::bench {

struct Scene {
  std::string part, name, state;
  Model start;        ///< It may be rigid or not: it is timed both ways.
  long steps = 0;     ///< At least so many steps are made before the timing.
  double time = 0.0;  ///< [T] The timing does not begin earlier.
  /// [T] The program and the linked lists start over after that time; 0 means never.
  double window = 0.0;
};

/// Returns the scene's model at the moment when the timing begins.
Model advanced(const Scene& scene, bool rigid);

constexpr const char* calm_state = "calm";
constexpr const char* chatter_state = "chatter";

/// Returns the name of the wall of 10^power bricks: "wall, 10,000 bricks".
std::string wall_name(int power);

/// With FRACTION 0.025 the bricks settle, and hardly a contact begins or ends.
Scene calm_wall(int power);
/// With FRACTION 0.1 the step is too long for the dashpots, so the bricks rattle on.
Scene chattering_wall(int power);
/// The polygons have fallen on one another and settle.
Scene settling_pile(int polygons);
/// Layers of bricks slide on an inclined floor and on each other.
Scene slope_scene();
/// The crater deck runs from its start until the blast ends.
Scene crater_scene();
/// The subsidence deck runs in the middle of the cave-in.
Scene subsidence_scene();

}  // namespace blocks::bench
