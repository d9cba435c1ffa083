// The scenes of the benchmark, each in the state in which it is timed.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks::bench {

struct Scene {
  std::string part, name, state;
  Model start;        ///< rigid or not: it is timed both ways
  long steps = 0;     ///< made before the timing, at least
  double time = 0.0;  ///< [T] the timing does not begin earlier
  /// [T] The program and the linked lists start over after that time; 0: never.
  double window = 0.0;
};

/// The scene's model when the timing begins, rigid or deformable.
Model advanced(const Scene& scene, bool rigid);

constexpr const char* calm_state = "calm";
constexpr const char* chatter_state = "chatter";

/// "wall, 10,000 bricks": of 10^power.
std::string wall_name(int power);

/// FRACTION 0.025: the bricks settle, and hardly a contact begins or ends.
Scene calm_wall(int power);
/// FRACTION 0.1: the step is too long for the dashpots, so the bricks rattle for ever.
Scene chattering_wall(int power);
/// Polygons that have fallen on one another and settle.
Scene settling_pile(int polygons);
/// Layers of bricks that slide on an inclined floor and on each other.
Scene slope_scene();
/// The crater deck while the blast acts, again and again from its start.
Scene crater_scene();
/// The subsidence deck in the middle of the cave-in.
Scene subsidence_scene();

}  // namespace blocks::bench
