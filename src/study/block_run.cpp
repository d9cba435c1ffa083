#include "study/block_run.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/step.hpp"

namespace blocks::study {

double distance_apart(const BlockPlace& a, const BlockPlace& b, double arm) {
  return (a.centroid - b.centroid).norm() + arm * std::abs(a.angle - b.angle);
}

BlockRun::BlockRun(const Model& start, const Variant& variant)
    : model(start), rules_(variant.start()) {
  dynamics::prepare(model);
  moving_ = model.blocks.size() - 1;
  kinetic_ = totals(model).kinetic_energy;
  start_ = model.blocks.centroid.col(moving_);
}

bool BlockRun::step() {
  rules_->find(model, work_);
  const bool finite = rules_->step(model, work_).finite;
  const Vec2 way = Vec2(model.blocks.centroid.col(moving_)) - start_;
  fallen_ = std::max(fallen_, model.settings.gravity.dot(way));
  return finite;
}

BlockPlace BlockRun::place() const {
  return {model.blocks.centroid.col(moving_), model.blocks.angle[moving_]};
}

double BlockRun::arm() const {
  double longest = 0.0;
  for (const Vec2& corner : outline())
    longest =
        std::max(longest, (corner - Vec2(model.blocks.centroid.col(moving_))).norm());
  return longest;
}

double BlockRun::deepest_contact() const {
  double deepest = 0.0;
  for (const Contact& contact : model.contacts)
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
