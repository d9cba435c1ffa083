// Scenes in which a wedge lies in a notch that several blocks form.
#include <cmath>

#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {

/// A wedge rests with its tip at the bottom of a notch between two blocks that are
/// flush or have a small gap between them. The half angle of the notch is 15 to 60
/// degrees.
///
/// - The wedge fits into the notch, or it is narrower and leans on the left wall.
/// - The blocks of the notch are fixed, or they are free in a trough of fixed boxes.
/// - A vertical joint may divide the left wall, so that three blocks form the notch.
///
/// The centroid of a narrower wedge is on the left of its tip, so it does not tip over.
Scene notch(Draws& draw) {
  SceneBuilder draft("notch", "a wedge rests in a notch between blocks", 1500);
  draft.rub(0.6, 0.5);
  draft.stiffness(1e8);
  const double half = radians(draw.between(15, 60)), slope = std::tan(half);
  const bool fits = draw.below(2) == 0, fixed = draw.below(2) == 0,
             is_divided = draw.below(2) == 0;
  const double gap = draw.below(2) == 0 ? 0.0 : draw.between(1e-7, 1e-5);
  const double wedge = fits ? half : half * draw.between(0.4, 0.9);
  constexpr double top = 1.3, below = 1.0;
  const double out = top * slope + 1.0;  // from the bottom of the notch to the trough
  const double cut = is_divided ? top * slope * draw.between(0.2, 0.8) : 0.0;
  // The wedge is block 0. Its sides are one metre long.
  const double first = -half, last = first + 2.0 * wedge;
  draft.add(
      {{0, 0}, {std::sin(first), std::cos(first)}, {std::sin(last), std::cos(last)}},
      false);
  draft.add({{gap, -below},
             {gap, 0},
             {gap + top * slope, top},
             {gap + out, top},
             {gap + out, -below}},
            fixed);
  if (is_divided) {
    draft.add({{-cut, -below}, {-cut, cut / slope}, {0, 0}, {0, -below}}, fixed);
    draft.add({{-out, -below},
               {-out, top},
               {-top * slope, top},
               {-cut, cut / slope},
               {-cut, -below}},
              fixed);
  } else {
    draft.add({{-out, -below}, {-out, top}, {-top * slope, top}, {0, 0}, {0, -below}},
              fixed);
  }
  if (!fixed) {
    draft.box(-out - 1, -below - 1, 2 * out + 2 + gap, 1, true);
    draft.box(-out - 1, -below, 1, below + top, true);
    draft.box(gap + out, -below, 1, below + top, true);
  }
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

}  // namespace blocks::study::scenes
