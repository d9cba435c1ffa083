// The scene `cut`: a closed joint is not there. A random domain is cut by random
// joints, and a block moves on it as on the domain in one piece.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "geometry/polygon.hpp"
#include "study/cut_action.hpp"
#include "study/cut_domain.hpp"
#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {
namespace {

constexpr double density = 2000.0;
constexpr long steps_of_a_run = 1600;
/// The time step as a part of the critical one. It has to be small, because several
/// springs and dashpots may act at once.
constexpr double part_of_critical = 0.05;

/// Half of the frames have flush pieces. In the others each piece is shifted by at most
/// half of this part of the overlap, so that joints are open or overlap.
double draw_gap(Draws& draw, const CutAction& action) {
  const bool flush = draw.below(2) == 0;
  const double part = std::exp(draw.between(std::log(0.01), std::log(0.5)));
  const double overlap = std::min(action.overlap, action.rest_overlap);
  return flush ? 0.0 : part * overlap;
}

Polygon shifted(Polygon outline, const Vec2& by) {
  for (Vec2& p : outline)
    p += by;
  return outline;
}

/// A model with these fixed outlines and the block, which is the last one.
Model make_model(const std::vector<Polygon>& fixed, const CutAction& action) {
  SceneBuilder draft("cut", "", steps_of_a_run);
  for (const Polygon& piece : fixed)
    draft.add(piece, true);
  const int b = draft.add(action.block, false);
  const double mass = draft.model().blocks.mass[b];
  const double stiffness = mass / (action.overlap * action.overlap);
  draft.stiffness(stiffness);
  draft.rub(action.friction, action.damping);
  // The lightest block determines the time step, even if it is fixed. All models have
  // the step of the moving block.
  draft.fraction(part_of_critical *
                 std::sqrt(mass / draft.model().blocks.mass.minCoeff()));
  const Vec2 gravity = action.rest_overlap * stiffness / mass * action.load;
  draft.gravity(gravity.x(), gravity.y());
  draft.velocity(b, action.velocity.x(), action.velocity.y());
  draft.spin(b, action.spin);
  return draft.model();
}

int draw_joints(Draws& draw) {
  const int kind = draw.below(10);
  return kind < 1 ? 0 : kind < 4 ? 1 : kind < 7 ? 2 : kind < 9 ? 3 : 5;
}

}  // namespace

Scene cut_by(Draws& draw, int joints) {
  const auto& kinds = domain_kinds();
  CutDomain domain = draw_domain(
      draw,
      kinds[static_cast<std::size_t>(draw.below(static_cast<int>(kinds.size())))]);
  cut_domain(draw, joints, domain);
  const CutAction action = draw_action(draw, domain);
  const double gap = domain.pieces.size() > 1 ? draw_gap(draw, action) : 0.0;
  std::vector<Polygon> pieces;
  for (const Polygon& piece : domain.pieces) {
    const double length = 0.5 * gap * draw(), angle = 2.0 * std::numbers::pi * draw();
    pieces.push_back(shifted(piece, length * Vec2(std::cos(angle), std::sin(angle))));
  }
  Scene scene;
  scene.name = "cut";
  scene.what = "a block moves on a domain cut by joints as on the domain in one piece";
  scene.kind = domain.kind + ' ' + action.kind;
  scene.model = make_model(pieces, action);
  scene.model.settings.title =
      fmt::format("{}: {} {}, {} pieces, overlap {:.1e}, {}", scene.name, domain.kind,
                  action.kind, pieces.size(), action.overlap,
                  gap > 0.0 ? fmt::format("shifted by up to {:.1e}", gap) : "flush");
  scene.steps = steps_of_a_run;
  scene.farthest = 1e6;
  scene.known_motion = false;
  double sharpest = domain.sharpest;
  if (sharpest < 0.49 * std::numbers::pi)
    sharpest = std::min(sharpest, 0.5 * radians(sharpest_angle(action.block)));
  scene.uncut = std::make_shared<const UncutScene>(
      UncutScene{make_model({domain.outline}, action),
                 make_model({marked_outline(domain)}, action), gap, sharpest});
  scene.expected = [n = scene.model.blocks.size()](long, double) {
    return Eigen::Matrix2Xd(Eigen::Matrix2Xd::Zero(2, n));
  };
  return scene;
}

Scene cut(Draws& draw) {
  const int joints = draw_joints(draw);
  return cut_by(draw, joints);
}

}  // namespace blocks::study::scenes
