// The scenes of the benchmark, each in the state in which it is timed.
#pragma once

#include <string>

#include "model/model.hpp"
#include "rock.hpp"

namespace blocks::bench {

struct Scene {
  std::string part, name, state;
  Model start;        ///< rigid or not: it is timed both ways
  long steps = 0;     ///< minimum number of steps before the timing
  double time = 0.0;  ///< [T] earliest time of the timing
  /// [T] The program and the linked lists restart after this time; 0: never.
  double window = 0.0;
};

/// Returns the model of the scene when the timing begins.
Model advanced(const Scene& scene, bool rigid);

/// Rock cut by joints: at rest, creeping or failing (rock.hpp).
Scene rock_scene(Cut cut, int blocks, Support support);
/// The same rock at rest, with laws of joints.
Scene rock_with_laws(Cut cut, int blocks);

constexpr const char* calm_state = "calm";
constexpr const char* chatter_state = "chatter";

/// Returns the name of the wall of 10^power bricks: "wall, 10,000 bricks".
std::string wall_name(int power);

/// With FRACTION 0.025 the bricks settle, and contacts hardly begin or end.
Scene calm_wall(int power);
/// With FRACTION 0.1 the step is too long for the dashpots, so the bricks never settle.
Scene chattering_wall(int power);
/// The polygons fall, settle after they have fallen on one another, or are nearly at
/// rest.
Scene falling_pile(int polygons);
Scene settling_pile(int polygons);
Scene resting_pile(int polygons);
/// Layers of bricks slide on an inclined floor and on each other.
Scene slope_scene();
/// The crater deck is timed from its start until the blast ends.
Scene crater_scene();
/// The subsidence deck is timed in the middle of the cave-in.
Scene subsidence_scene();

}  // namespace blocks::bench
