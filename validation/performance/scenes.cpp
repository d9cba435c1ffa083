#include "scenes.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "blocks_code.hpp"
#include "deck_model.hpp"
#include "geometry/random.hpp"
#include "pile.hpp"
#include "report.hpp"
#include "slope.hpp"
#include "wall.hpp"

namespace blocks::bench {
namespace {

constexpr long batch = 100;  // steps between two tests of the time

// At a FRACTION of 0.1 and half of critical damping a wall never comes to rest.
constexpr double chatter_fraction = 0.1;
// The bricks meet within this many steps and settle later.
constexpr long wall_steps = 100;
// [L/T] The first velocity of a brick is at most this; a larger one opens joints.
constexpr double kick = 0.02;

// [T] The layers fall less than 3 [L] in this time and have met.
constexpr double pile_time = 1.5;
// [T] The pile changes little in this time.
constexpr double pile_window = 0.1;
constexpr double pile_falls = 0.3, pile_rests = 3.0;  // [T]

// A large rock is timed while it settles into its joints, after this many steps.
constexpr int large_rock = 10'000;
constexpr long rock_steps = 200;
// [T] By then the rock is at rest, or creeps behind the wall, or its front falls.
constexpr double rock_time = 0.4, rock_window = 0.1;

// The layers settle on the floor within this many steps.
constexpr long slope_steps = 1000;
// [T] The slope gains 0.8 [L/T] in this time.
constexpr double slope_window = 0.5;

constexpr double blast_window = 0.01;  // [T] end of the pressure of the deck

// [T] The roof falls fastest from this time on, for the length of the window.
constexpr double cave_in_time = 0.6;
constexpr double cave_in_window = 0.2;

/// Makes all bricks move at once. Otherwise the weight would have to reach them first.
void kick_bricks(Blocks& blocks) {
  for (int b = 0; b < blocks.size(); ++b)
    for (int axis = 0; axis < 2 && blocks.is_free(b); ++axis) {
      const auto bits =
          geometry::random_53_bits({1982, 0}, static_cast<std::uint64_t>(b),
                                   static_cast<std::uint32_t>(axis), 0);
      blocks.velocity(axis, b) =
          kick * (2.0 * static_cast<double>(bits) * 0x1p-53 - 1.0);
    }
}

Scene deck_scene(const std::string& name, const std::string& state) {
  Scene scene{.part = name, .name = {}, .state = state, .start = deck_model(name)};
  scene.name = name + " deck, " + grouped(free_blocks(scene.start)) + " blocks";
  return scene;
}

}  // namespace

Model advanced(const Scene& scene, bool rigid) {
  Model start = scene.start;
  start.settings.rigid = rigid;
  BlocksCode code(std::move(start));
  code.run(scene.steps);
  while (code.model().time < scene.time)
    code.run(batch);
  return code.model();
}

std::string wall_name(int power) {
  return "wall, " + grouped(std::lround(std::pow(10.0, power))) + " bricks";
}

Scene calm_wall(int power) {
  return {.part = "wall",
          .name = wall_name(power),
          .state = calm_state,
          .start = wall_of_power(power),
          .steps = wall_steps};
}

Scene chattering_wall(int power) {
  Scene scene = calm_wall(power);
  scene.state = chatter_state;
  scene.start.settings.fraction = chatter_fraction;
  kick_bricks(scene.start.blocks);
  return scene;
}

Scene rock_scene(Cut cut, int blocks, Support support) {
  Scene scene{
      .part = "rock", .name = {}, .state = {}, .start = cut_rock(cut, blocks, support)};
  scene.name = (cut == Cut::voronoi ? "Voronoi cells, " : "two joint sets, ") +
               grouped(free_blocks(scene.start)) + " blocks";
  if (blocks >= large_rock) {
    scene.state = "settling", scene.steps = rock_steps;
    return scene;
  }
  scene.state = support == Support::walls           ? "at rest"
                : support == Support::receding_wall ? "creeping"
                                                    : "failing";
  scene.time = rock_time;
  if (support != Support::walls)
    scene.window = rock_window;
  return scene;
}

Scene rock_with_laws(Cut cut, int blocks) {
  Scene scene = rock_scene(cut, blocks, Support::walls);
  scene.start = cut_rock(cut, blocks, Support::walls, true);
  scene.state = "at rest, laws";
  return scene;
}

Scene falling_pile(int polygons) {
  Scene scene = settling_pile(polygons);
  scene.state = "falling", scene.time = pile_falls;
  return scene;
}

Scene settling_pile(int polygons) {
  return {.part = "pile",
          .name = "pile, " + grouped(polygons) + " polygons",
          .state = "settling",
          .start = loose_pile(polygons),
          .time = pile_time,
          .window = pile_window};
}

Scene resting_pile(int polygons) {
  Scene scene = settling_pile(polygons);
  scene.state = "at rest", scene.time = pile_rests;
  return scene;
}

Scene slope_scene() {
  Scene scene{.part = "slope",
              .name = {},
              .state = "sliding",
              .start = sliding_slope(),
              .steps = slope_steps,
              .window = slope_window};
  scene.name = "slope, " + grouped(free_blocks(scene.start)) + " bricks";
  return scene;
}

Scene crater_scene() {
  Scene scene = deck_scene("crater", "blast");
  scene.window = blast_window;
  return scene;
}

Scene subsidence_scene() {
  Scene scene = deck_scene("subsidence", "cave-in");
  scene.time = cave_in_time;
  scene.window = cave_in_window;
  return scene;
}

}  // namespace blocks::bench
