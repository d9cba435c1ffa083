// Scenes in which a block slides or rolls over a floor of pieces.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dynamics/step.hpp"
#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {

namespace {

/// A box of 1 m slides at 10 m/s over `boxes` fixed boxes.
Scene braked(SceneBuilder draft, double friction, int boxes) {
  constexpr double speed = 10.0;
  draft.rub(friction, 0.2);
  for (int i = 0; i < boxes; ++i)
    draft.box(i - 1, -1, 1, 1, true);
  const int b = draft.box(0, 0, 1, 1);
  draft.velocity(b, speed, 0);
  draft.gravity(0, -g);
  return draft.moves(b, [friction](long k, double dt) {
    const double t = static_cast<double>(k) * dt;
    return Vec2(speed * t - 0.5 * friction * g * t * t, 0);
  });
}

}  // namespace

Scene floor_of_boxes() {
  return braked(
      {"floor", "a box slides over a floor of boxes and is braked by friction", 1060},
      0.4, 10);
}

Scene soft_floor() {
  SceneBuilder draft(
      "soft",
      "a box slides over a floor of boxes so soft that it sinks in by 1 % of "
      "their width",
      600);
  draft.stiffness(1e6);
  return braked(draft, 0.1, 20);
}

Scene nose() {
  SceneBuilder draft(
      "nose", "a block with a front of 40 degrees is pulled over a floor of boxes",
      1600);
  draft.stiffness(1e6);
  draft.rub(0.0, 0.1);
  for (int i = 0; i < 10; ++i)
    draft.box(0.25 * i - 1.25, -1, 0.25, 1, true);
  const double back = 0.3 / std::tan(40.0 * std::numbers::pi / 180.0);
  const int b = draft.add({{-1, 0}, {-1, 0.3}, {-back, 0.3}, {0, 0}}, false);
  draft.gravity(0.3, -g);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(0.15 * static_cast<double>(k) * static_cast<double>(k + 1) * dt * dt,
                0);
  });
}

namespace {

/// Friction brakes the box by mu g, however deep it sinks in, because the joints are
/// closed: the sides of the fixed boxes cannot be touched. A box that starts without
/// overlap first sinks in twice as deep as at rest.
Scene sunken(const char* name, const char* what, double stiffness, double share,
             long steps) {
  SceneBuilder draft(name, what, steps);
  draft.stiffness(stiffness);
  Scene scene = braked(draft, 0.1, 20);
  scene.max_shared = scene.max_sinking = 2.5 * share;
  return scene;
}

}  // namespace

Scene soft_floor_4() {
  return sunken(
      "soft4", "a box slides over boxes so soft that it sinks in by 4 % of their width",
      2.5e5, 0.04, 300);
}

Scene soft_floor_8() {
  return sunken(
      "soft8", "a box slides over boxes so soft that it sinks in by 8 % of their width",
      1.25e5, 0.08, 220);
}

/// The bow rises forwards from the floor. The base is frictionless and the floor flush,
/// so nothing slows the block down: it keeps the speed that it starts with.
Scene bow() {
  constexpr double speed = 1.0;
  SceneBuilder draft(
      "bow", "a block with a bow of 5 degrees slides over a soft floor of boxes", 800);
  draft.stiffness(2e5);
  draft.rub(0.0, 0.1);
  for (int i = 0; i < 16; ++i)
    draft.box(0.25 * i - 2, -1, 0.25, 1, true);
  const int b = draft.add(
      {{-1.5, 0}, {-1.5, 0.3}, {0.5, 0.3}, {0.5, 0.5 * std::tan(radians(5))}, {0, 0}},
      false);
  draft.velocity(b, speed, 0);
  draft.gravity(0, -g);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(speed * static_cast<double>(k) * dt, 0);
  });
}

namespace {

constexpr int pieces = 24;
constexpr double piece_length = 0.25;

/// A regular polygon that rolls about its front lower corner, without a floor.
SceneBuilder rolling(int corners) {
  constexpr double radius = 0.5, speed = 1.2;
  SceneBuilder draft("roller",
                     "a regular polygon rolls over a floor of 24 flush pieces", 1400);
  draft.fraction(0.05);
  draft.rub(0.5, 0.3);
  const double half = std::numbers::pi / corners;
  geometry::Polygon outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = half - 0.5 * std::numbers::pi - 2.0 * half * i;
    outline.emplace_back(radius * std::cos(angle),
                         radius * (std::sin(angle) + std::cos(half)));
  }
  const int b = draft.add(outline, false);
  draft.velocity(b, speed * std::cos(half), speed * std::sin(half));
  draft.spin(b, -speed / radius);
  draft.gravity(0.5, -g);
  return draft;
}

SceneBuilder rolling_on_pieces(int corners, double floor) {
  SceneBuilder draft = rolling(corners);
  for (int i = 0; i < pieces; ++i)
    draft.box(piece_length * i + floor, -10, piece_length, 10, true);
  return draft;
}

/// The floor is one block, with two corners at each place where pieces would meet.
SceneBuilder rolling_on_one_block(int corners, double floor) {
  constexpr double apart = 1e-6;
  geometry::Polygon outline{{floor, -10}, {floor, 0}};
  for (int i = 1; i < pieces; ++i)
    for (const double beside : {-0.5 * apart, 0.5 * apart})
      outline.emplace_back(piece_length * i + floor + beside, 0);
  outline.emplace_back(piece_length * pieces + floor, 0);
  outline.emplace_back(piece_length * pieces + floor, -10);
  SceneBuilder draft = rolling(corners);
  draft.add(outline, true);
  return draft;
}

}  // namespace

/// The joints of a fixed flush floor are closed. So the polygon must roll as it does
/// over a floor of one block with the same corners. That run is made here by the
/// default rules. The floor's pieces are heavier than the polygon, so both runs have
/// the same time step.
///
/// The corners of the floor matter. A side of the polygon that comes down flat also
/// strikes them, so less speed is lost than on a floor without corners.
Scene roller(Draws& draw) {
  const int corners = 12 + draw.below(13);
  const double floor = draw.between(-1.25, -1.0);
  SceneBuilder draft = rolling_on_pieces(corners, floor);
  Model single = rolling_on_one_block(corners, floor).model();
  dynamics::Workspace work;
  dynamics::prepare(single);
  const Vec2 start = single.blocks.centroid.col(0);
  std::vector<Vec2> way = {Vec2(0, 0)};
  Scene scene = draft.rests(1.0);
  for (long k = 0; k < scene.steps; ++k) {
    dynamics::step(single, work);
    way.push_back(Vec2(single.blocks.centroid.col(0)) - start);
  }
  scene = draft.moves(0, [way](long k, double) {
    return way[std::min(static_cast<std::size_t>(k), way.size() - 1)];
  });
  scene.known_motion = false;  // the phase of the polygon may differ
  scene.mean_speed = true;
  return scene;
}

}  // namespace blocks::study::scenes
