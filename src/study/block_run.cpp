#include "study/block_run.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/preparation/bond.hpp"
#include "dynamics/step.hpp"

namespace blocks::study {
namespace {

/// Faces at most so far apart are bonded, as a part of the contact tolerance.
constexpr double flush = 1e-5;

}  // namespace

double distance_apart(const BlockPlace& a, const BlockPlace& b, double arm) {
  return (a.centroid - b.centroid).norm() + arm * std::abs(a.angle - b.angle);
}

BlockRun::BlockRun(const Model& start, const Variant& variant)
    : model(start), rules_(variant.start()) {
  if (!model.settings.joint_laws.empty())
    dynamics::bond_faces(model, 0, flush * model.settings.contact_tolerance);
  dynamics::prepare(model);
  moving_ = model.blocks.size() - 1;
  kinetic_ = totals(model).kinetic_energy;
  start_ = model.blocks.centroid;
}

bool BlockRun::step() {
  rules_->find(model, work_);
  const bool finite = rules_->step(model, work_).finite;
  const Vec2 way = Vec2(model.blocks.centroid.col(moving_)) - start_.col(moving_);
  fallen_ = std::max(fallen_, model.settings.gravity.dot(way));
  return finite;
}

BlockPlace BlockRun::place() const {
  return {model.blocks.centroid.col(moving_), model.blocks.angle[moving_]};
}

double BlockRun::arm_of(int block) const {
  double longest = 0.0;
  for (const Vec2& corner : model.blocks.outline(block))
    longest =
        std::max(longest, (corner - Vec2(model.blocks.centroid.col(block))).norm());
  return longest;
}

double BlockRun::yielding() const {
  double max = 0.0;
  for (int b = 0; b < moving_; ++b)
    if (model.blocks.is_free(b))
      max = std::max(
          max, distance_apart({model.blocks.centroid.col(b), model.blocks.angle[b]},
                              {start_.col(b), 0.0}, arm_of(b)));
  return max;
}

double BlockRun::deepest_contact() const {
  const std::vector<int>& block = model.blocks.corner_block;
  double deepest = 0.0;
  for (const Contact& contact : model.contacts)
    if (block[contact.corner] == moving_ || block[contact.edge] == moving_)
      deepest = std::max(deepest, contact.overlap);
  return deepest;
}

double BlockRun::energy_overlap() const {
  const double energy = kinetic_ + model.blocks.mass[moving_] * fallen_;
  return 2.0 * std::sqrt(energy / model.settings.normal_stiffness);
}

double BlockRun::load_overlap() const {
  return 2.0 * model.blocks.mass[moving_] * model.settings.gravity.norm() /
         model.settings.normal_stiffness;
}

void disturb_last_block(Blocks& blocks, const Vec2& shift, double turn) {
  const int b = blocks.size() - 1;
  const double c = std::cos(turn), s = std::sin(turn);
  blocks.centroid.col(b) += shift;
  blocks.gradient.col(b) << c, -s, s, c;
  for (int k = blocks.first_corner[b]; k < blocks.first_corner[b + 1]; ++k) {
    const Vec2 arm = blocks.arm.col(k);
    blocks.corner.col(k) = Vec2(blocks.centroid.col(b)) +
                           Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
  }
}

}  // namespace blocks::study
