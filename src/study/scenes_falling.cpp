// Scenes in which a block leaves its neighbours or falls past them.
#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {

Scene figure4b() {
  SceneBuilder draft("figure4b",
                     "of two blocks side by side one is fixed and one falls", 530);
  draft.box(0, 0, 1, 1, true);
  const int b = draft.box(-1, 0, 1, 1);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene diagonal() {
  SceneBuilder draft(
      "diagonal", "a block falls past the top corner of its diagonal neighbour", 530);
  draft.box(0, 0, 1, 1, true);
  const int b = draft.box(-1, 1, 1, 1);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene wedge() {
  SceneBuilder draft("wedge",
                     "a wedge slides along one slanted face and leaves the other", 530);
  draft.add({{-3, 0}, {-3, 1}, {-0.3, 1}, {-0.6, 0}}, true);
  draft.add({{0.6, 0}, {0.3, 1}, {3, 1}, {3, 0}}, true);
  const int b = draft.add({{-0.6, 0}, {-0.3, 1}, {0.3, 1}, {0.6, 0}}, false);
  const Vec2 down = Vec2(-0.3, -1.0).normalized();
  draft.gravity(g * down.x(), g * down.y());
  return draft.falls(b);
}

Scene tee() {
  SceneBuilder draft(
      "tee", "a block moves out of two T-junctions, between a floor and a ceiling",
      530);
  draft.box(-2, -1, 6, 1, true);
  draft.box(-2, 1, 6, 1, true);
  draft.box(-1, 0, 1, 1, true);
  const int b = draft.box(0, 0, 1, 1);
  draft.gravity(g, 0);
  return draft.falls(b);
}

Scene shaft() {
  SceneBuilder draft("shaft", "a brick falls down a shaft of bricks exactly as wide",
                     1060);
  for (int i = 0; i < 6; ++i) {
    draft.box(-1, -0.5 * i, 1, 0.5, true);
    draft.box(1, -0.5 * i, 1, 0.5, true);
  }
  const int b = draft.box(0, 0, 1, 0.5);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene slot() {
  SceneBuilder draft(
      "slot", "a thin slab falls down a slot exactly as wide, pressed to a side", 1500);
  draft.box(-1.02, -1, 1, 1, true);
  draft.box(0, -1, 1, 1, true);
  const int b = draft.box(-0.02, -0.05, 0.02, 0.2);
  draft.gravity(0.01 * g, -g);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(0, -0.5 * g * static_cast<double>(k) * static_cast<double>(k + 1) * dt *
                       dt);
  });
}

Scene slab() {
  SceneBuilder draft("slab",
                     "a thin plate passes under a thin slab without touching it", 1000);
  draft.box(0, 0, 1, 0.1, true);
  draft.rub(0.4, 0.0);
  const int b = draft.box(-1.1, -0.06, 1, 0.05);
  draft.velocity(b, 10, -0.1);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(static_cast<double>(k) * dt * Vec2(10, -0.1));
  });
}

/// The bricks of the shaft are free here, so all bricks begin to fall in the same step.
/// The shaft must stay, because it stands on a floor. The brick between its sides has
/// nothing below it and touches them without pressure, so it must fall freely.
Scene bricks() {
  SceneBuilder draft("bricks",
                     "a brick falls down a shaft of free bricks exactly as wide", 1060);
  draft.box(-2, -2.5, 1, 3, true);
  draft.box(2, -2.5, 1, 3, true);
  draft.box(-2, -3.5, 5, 1, true);
  const int b = draft.box(0, 0, 1, 0.5);
  for (int i = 0; i < 6; ++i) {
    draft.box(-1, -0.5 * i, 1, 0.5);
    draft.box(1, -0.5 * i, 1, 0.5);
  }
  draft.gravity(0, -g);
  return draft.falls(b);
}

}  // namespace blocks::study::scenes
