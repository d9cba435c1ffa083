#include "model/local_ratio.hpp"

#include <algorithm>
#include <cmath>

#include "model/equilibrium.hpp"
#include "model/load_sizes.hpp"

namespace blocks {
namespace {

/// Returns the sum of the sizes of all forces on each block, [F] (n).
Eigen::VectorXd sums_of_forces(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double time = time_of_forces(model);
  Eigen::VectorXd sums = blocks.mass * model.settings.gravity_at(time).norm();
  each_load(model, time, [&](int block, double size) { sums[block] += size; });
  for (const Contact& contact : model.contacts) {
    const double size = Vec2(contact.normal_force, contact.shear_force).norm();
    const auto [low, high] = pair_of(blocks, contact);
    sums[low] += size, sums[high] += size;
  }
  for (const PlaneContact& contact : model.plane_contacts)
    sums[blocks.corner_block[contact.corner]] += contact.normal_force;
  return sums;
}

}  // namespace

void local_ratios(const Model& model, Eigen::VectorXd& ratios) {
  const Blocks& blocks = model.blocks;
  const Eigen::VectorXd sums = sums_of_forces(model);
  double largest = 0.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      largest = std::max(largest, sums[b]);
  unbalanced_forces(model, ratios);
  for (int b = 0; b < blocks.size(); ++b)
    ratios[b] = blocks.is_free(b) && sums[b] > negligible_forces * largest
                    ? ratios[b] / sums[b]
                    : 0.0;
}

Balance balance_of(const Model& model) {
  Balance balance{unbalanced_ratio(model), 0.0, -1};
  Eigen::VectorXd ratios;
  local_ratios(model, ratios);
  for (int b = 0; b < model.blocks.size(); ++b)
    if (ratios[b] > balance.local)
      balance.local = ratios[b], balance.block = b;
  return balance;
}

}  // namespace blocks
