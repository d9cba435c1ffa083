// Columns on a stepped base at the limit angle of toppling (Goodman and Bray 1976).
#include <cmath>

#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {
namespace {

constexpr int columns = 4;
constexpr double width = 1.0, height = 2.0, rise = 0.2;  ///< of columns and steps, [L]

/// The angle by which a column on its toe has turned after the time t, if the slope is
/// steeper than the limit by `excess`: R angle'' = (3/4) g sin(excess + angle). R is
/// half a diagonal.
double turned(double excess, double t) {
  const double rate = 0.75 * g / (0.5 * std::hypot(width, height));  // [1/T^2]
  constexpr int steps = 1000;
  const double dt = t / steps;
  double angle = 0.0, spin = 0.0;
  for (int i = 0; i < steps; ++i) {
    spin += rate * std::sin(excess + angle) * dt;
    angle += spin * dt;
  }
  return angle;
}

/// Equal columns on the steps of a base that dips to the right. A column topples if the
/// tangent of the dip is above width over height. Equal columns turn about their toes
/// at the same time without pressing each other, so the limit of one is that of the
/// row. Friction (mu = 1) is twice what they need in order not to slide. Half of the
/// frames dip by 0.5 to 1 degree less than the limit: the columns must stand. The
/// others dip by as much more: they must topple.
Scene columns_on(SceneBuilder draft, Draws& draw) {
  const bool topples = draw.below(2) == 1;
  const double excess = radians((topples ? 1.0 : -1.0) * draw.between(0.5, 1.0));
  const double dip = std::atan(width / height) + excess;
  draft.rub(1.0, 0.3);
  draft.stiffness(3e7);
  draft.fraction(0.05);
  draft.gravity(g * std::sin(dip), -g * std::cos(dip));
  const int first = draft.model().blocks.size();
  for (int i = 0; i < columns; ++i)
    draft.box(i * width, -i * rise, width, height);
  Scene scene = draft.rests(1.0);
  scene.known_motion = false;
  if (!topples) {
    scene.max_sinking = 0.02;
    return scene;
  }
  scene.min_share = 0.3;
  scene.max_sinking = 1.0;
  const int n = draft.model().blocks.size();
  scene.expected = [excess, first, n](long k, double dt) {
    const double angle = -turned(excess, static_cast<double>(k) * dt);
    const Vec2 arm(-0.5 * width, 0.5 * height);  // from the toe to the centroid
    const Vec2 now(arm.x() * std::cos(angle) - arm.y() * std::sin(angle),
                   arm.x() * std::sin(angle) + arm.y() * std::cos(angle));
    Eigen::Matrix2Xd all = Eigen::Matrix2Xd::Zero(2, n);
    for (int b = first; b < n; ++b)
      all.col(b) = now - arm;
    return all;
  };
  return scene;
}

}  // namespace

Scene step_notch(Draws& draw) {
  SceneBuilder draft("step-notch", "columns on a stepped base of one non-convex block",
                     1200);
  geometry::Polygon base = {{0, -3}};
  for (int i = 0; i < columns; ++i) {
    base.emplace_back(i * width, -i * rise);
    base.emplace_back((i + 1) * width, -i * rise);
  }
  base.emplace_back(columns * width, -3);
  draft.add(base, true);
  return columns_on(draft, draw);
}

Scene step_flush(Draws& draw) {
  SceneBuilder draft("step-flush", "columns on a stepped base of flush blocks", 1200);
  for (int i = 0; i < columns; ++i)
    draft.box(i * width, -3, width, 3 - i * rise, true);
  return columns_on(draft, draw);
}

/// A slab reaches back below the next one up, so the slabs overlap from the start.
Scene step_slabs(Draws& draw) {
  SceneBuilder draft("step-slabs", "columns on a stepped base of slabs that overlap",
                     1200);
  for (int i = 0; i < columns; ++i)
    draft.box(i * width - 1.5, -i * rise - 1, width + 1.5, 1, true);
  return columns_on(draft, draw);
}

}  // namespace blocks::study::scenes
