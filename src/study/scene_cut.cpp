// The scenes `cut` and `bonded`: a closed joint is not there. A random domain is cut by
// random joints, and a block moves on it as on the domain in one piece. The pieces are
// fixed, or bonded to each other.
#include <fmt/format.h>

#include <algorithm>
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

double area_of(const Polygon& outline) {
  return geometry::section_properties(outline).area;
}

/// The stiffness of the bonds of a face of length 1, in stiffnesses of a contact.
constexpr double bond_stiffness = 10.0;

/// The density with which bonds and dashpots of the lightest piece are stable in the
/// time step of the block.
double density_of_bonded(const std::vector<Polygon>& pieces, double mass) {
  double smallest = area_of(pieces.front());
  for (const Polygon& piece : pieces)
    smallest = std::min(smallest, area_of(piece));
  return 40.0 * mass / smallest;
}

/// A model with these outlines and the block, which is the last one. The outlines are
/// fixed, or only the first one is and the others are free, to be bonded.
Model make_model(const std::vector<Polygon>& pieces, const CutAction& action,
                 bool bonded = false) {
  SceneBuilder draft("cut", "", steps_of_a_run);
  const double mass = density * area_of(action.block);
  const double stiffness = mass / (action.overlap * action.overlap);
  if (bonded) {
    JointLaw law;
    law.cohesion = law.tension = law.residual_cohesion = law.residual_tension =
        1e6 * stiffness;
    law.normal_stiffness = law.shear_stiffness = bond_stiffness * stiffness;
    draft.joint_material(density_of_bonded(pieces, mass), law);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    draft.add(pieces[i], !bonded || i == 0, bonded ? 2 : 1);
  const int b = draft.add(action.block, false);
  draft.stiffness(stiffness);
  draft.rub(action.friction, action.damping);
  // The lightest block determines the time step, even if it is fixed. All models have
  // the step of the moving block.
  draft.fraction(part_of_critical *
                 std::sqrt(mass / draft.model().blocks.mass.minCoeff()));
  const Vec2 gravity = action.rest_overlap * stiffness / mass * action.load;
  draft.gravity(gravity.x(), gravity.y());
  for (int piece = 1; bonded && piece < b; ++piece)
    draft.make_weightless(piece);
  draft.velocity(b, action.velocity.x(), action.velocity.y());
  draft.spin(b, action.spin);
  return draft.model();
}

int draw_joints(Draws& draw) {
  const int kind = draw.below(10);
  return kind < 1 ? 0 : kind < 4 ? 1 : kind < 7 ? 2 : kind < 9 ? 3 : 5;
}

/// The scene with so many joints, if the domain has space for them.
Scene domain_scene(Draws& draw, int joints, bool bonded) {
  const auto& kinds = domain_kinds();
  CutDomain domain = draw_domain(
      draw,
      kinds[static_cast<std::size_t>(draw.below(static_cast<int>(kinds.size())))]);
  cut_domain(draw, joints, domain);
  const CutAction action = draw_action(draw, domain);
  const double gap = domain.pieces.size() > 1 && !bonded ? draw_gap(draw, action) : 0.0;
  std::vector<Polygon> pieces;
  for (const Polygon& piece : domain.pieces) {
    const double length = 0.5 * gap * draw(), angle = 2.0 * std::numbers::pi * draw();
    pieces.push_back(shifted(piece, length * Vec2(std::cos(angle), std::sin(angle))));
  }
  if (bonded)  // the largest piece is fixed
    std::swap(pieces.front(),
              *std::max_element(pieces.begin(), pieces.end(),
                                [](const Polygon& one, const Polygon& other) {
                                  return area_of(one) < area_of(other);
                                }));
  Scene scene;
  scene.name = bonded ? "bonded" : "cut";
  scene.what = bonded ? "the same, but the pieces are free and bonded to each other"
                      : "a block moves on a domain cut by joints as on the domain in "
                        "one piece";
  scene.kind = domain.kind + ' ' + action.kind;
  scene.model = make_model(pieces, action, bonded);
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

}  // namespace

Scene cut_by(Draws& draw, int joints) { return domain_scene(draw, joints, false); }

Scene cut(Draws& draw) {
  const int joints = draw_joints(draw);
  return domain_scene(draw, joints, false);
}

Scene bonded(Draws& draw) {
  const int joints = std::max(1, draw_joints(draw));
  return domain_scene(draw, joints, true);
}

}  // namespace blocks::study::scenes
