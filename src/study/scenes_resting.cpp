// Scenes in which blocks come to rest.
#include <algorithm>
#include <cmath>

#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {

Scene stack() {
  SceneBuilder draft("stack", "four aligned bricks stand on a floor", 1500);
  draft.rub(0.6, 0.5);
  draft.box(-3, -1, 6, 1, true);
  for (int i = 0; i < 4; ++i)
    draft.box(-1, 0.5 * i, 2, 0.5);
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

Scene wall() {
  SceneBuilder draft("wall", "a brick wall in running bond stands on a floor", 1500);
  draft.rub(0.6, 0.5);
  draft.box(-1, -1, 6, 1, true);
  for (int row = 0; row < 4; ++row) {
    const bool even = row % 2 == 0;
    for (int i = 0; i < 4; ++i)
      if (even || i < 3)
        draft.box(i + (even ? 0.0 : 0.5), 0.5 * row, 1, 0.5);
    if (!even) {
      draft.box(0, 0.5 * row, 0.5, 0.5);
      draft.box(3.5, 0.5 * row, 0.5, 0.5);
    }
  }
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

namespace {

/// A convex polygon with its corners on an ellipse. `share` is the ratio of the shorter
/// axis to the longer one.
geometry::Polygon random_polygon(Draws& draw, const Vec2& centre, double radius,
                                 double share) {
  const int corners = 3 + draw.below(4);
  const double turn = draw.between(0, 360), tilt = radians(draw.between(0, 180));
  const Vec2 longer(std::cos(tilt), std::sin(tilt)), shorter(-longer.y(), longer.x());
  geometry::Polygon outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = radians(turn - 360.0 * (i + 0.6 * draw()) / corners);
    outline.push_back(centre + radius * (std::cos(angle) * longer +
                                         share * std::sin(angle) * shorter));
  }
  return outline;
}

}  // namespace

/// The free blocks are thrown on the terrain and come to rest on it, at unknown places,
/// but they may not sink in. If one spring takes up all the energy of the first impact,
/// at 6 m/s, a block of 500 kg overlaps by 4.2 cm. Half as much more is allowed,
/// because blocks strike each other.
Scene terrain(Draws& draw) {
  SceneBuilder draft("terrain", "blocks fall on a terrain of fixed blocks that overlap",
                     1500);
  draft.rub(0.5, 0.3);
  draft.fraction(0.05);
  for (int i = 0; i < 14; ++i)
    draft.add(random_polygon(draw, {0.37 * i - 2.4, draw.between(-1.2, -0.4)},
                             draw.between(0.3, 0.8), draw.between(0.2, 1.0)),
              true);
  draft.box(-3, -2, 0.5, 4, true);
  draft.box(2.5, -2, 0.5, 4, true);
  draft.box(-3, -2.2, 6, 1.2, true);
  for (int i = 0; i < 6; ++i) {
    const int b =
        draft.add(random_polygon(draw, {0.75 * i - 1.9, 0.8 + 0.1 * (i % 2)},
                                 draw.between(0.2, 0.35), draw.between(0.3, 1.0)),
                  false);
    draft.velocity(b, 0, -4);
  }
  draft.gravity(0, -g);
  Scene scene = draft.rests(1.0);
  scene.known_motion = false;
  scene.max_sinking = 2.5;
  scene.looks = 60;
  scene.max_shared = 1.0;
  scene.max_depth = 0.063;
  return scene;
}

/// The lower block lies flat on a pedestal, and its tip leans out over a gap that is
/// open below. The tip carries the upper block in one of three ways:
/// - One end of a plate lies on the tip, and the other end on a box of the same height.
/// - A plate lies on the lower block and overhangs the tip, with its centroid behind
///   it.
/// - A keystone hangs with its slanted sides on the tip and on the corner of the box.
///
/// The lower block does not tip over, because the upper one has less than half the
/// moment about the end of its base. So everything rests.
Scene undercut(Draws& draw) {
  SceneBuilder draft("undercut", "an undercut tip props a block over an open gap",
                     1200);
  draft.rub(0.5, 0.3);
  const double lean = std::tan(radians(draw.between(10, 50)));
  const int kind = draw.below(3);
  double gap = draw.below(3) == 0 ? 0.0 : draw.between(0, 0.3);
  const double margin =
      draw.below(2) == 0 ? draw.between(1e-4, 1e-2) : draw.between(0.01, 0.3);
  if (kind == 2)
    gap = draw.between(0.1, 0.5);
  draft.box(-3, -2, 2.5, 1.5, true);
  if (kind != 1)
    draft.box(gap, -2, 3, 2, true);
  // The lower block is half a metre thick, and its base ends where the lean begins.
  draft.add({{-2, -0.5}, {-2, 0}, {0, 0}, {-0.5 * lean, -0.5}}, false);
  if (kind == 0) {
    draft.box(-margin, 0, 1, 0.3);
  } else if (kind == 1) {
    const double before = std::max(margin, 0.02);  // centroid to tip
    draft.box(-before - 0.5, 0, 1, 0.3);
  } else {
    const double slope = draw.between(0.3, 1.5), above = 0.3, below = 0.3 * gap / slope;
    draft.add({{slope * below, -below},
               {-slope * above, above},
               {gap + slope * above, above},
               {gap - slope * below, -below}},
              false);
  }
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

}  // namespace blocks::study::scenes
