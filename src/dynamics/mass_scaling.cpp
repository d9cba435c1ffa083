#include "dynamics/mass_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/search/near_pairs.hpp"
#include "dynamics/time_step.hpp"
#include "model/safe_fraction.hpp"

namespace blocks::dynamics {
namespace {

/// Returns the squared distance of a point from the side that begins at corner c.
double distance_from_side(const Blocks& blocks, int c, const Vec2& point) {
  const Vec2 a = blocks.corner.col(c), along = blocks.corner.col(blocks.next[c]) - a;
  const double part =
      std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - part * along).squaredNorm();
}

/// Whether a point is within the tolerance of a side of block b, but of no corner.
bool is_near_a_side(const Blocks& blocks, int b, const Vec2& point, double tolerance) {
  const double square = tolerance * tolerance;
  bool near = false;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
    if ((Vec2(blocks.corner.col(c)) - point).squaredNorm() <= square)
      return false;
    near = near || distance_from_side(blocks, c, point) <= square;
  }
  return near;
}

/// Returns the critical step of each free block, [T] (n); 0 for other blocks.
Eigen::VectorXd critical_steps(const Model& model) {
  const Settings& settings = model.settings;
  const Eigen::VectorXi contacts =
      possible_contacts(model.blocks, settings.contact_tolerance);
  const auto fraction = [&](int count) {
    return safe_fraction(settings.damping, settings.local_damping, count);
  };
  // More dashpots shorten the safe step more than more springs do.
  return steps_of_blocks(model, contacts.unaryExpr([&](int count) {
    const double times = fraction(usual_contacts) / fraction(count);
    return count > usual_contacts ? times * times : 1.0;
  }));
}

/// Multiplies the velocities of block b by a factor.
void multiply_motion(Blocks& blocks, int b, double factor) {
  blocks.velocity.col(b) *= factor;
  blocks.spin[b] *= factor;
  blocks.strain_rate.col(b) *= factor;
}

/// Makes the present moment that from which the times of steps are counted.
void count_time_from_here(Model& model) {
  model.time_origin = model.time;
  model.step_origin = model.steps;
}

}  // namespace

Eigen::VectorXi possible_contacts(const Blocks& blocks, double tolerance) {
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      counts[b] = 2 * blocks.corners_of(b);
  const auto count_corners = [&](int b, int other) {
    if (!blocks.is_free(b))
      return;
    for (int c = blocks.first_corner[other]; c < blocks.first_corner[other + 1]; ++c)
      counts[b] += is_near_a_side(blocks, b, blocks.corner.col(c), tolerance);
  };
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(blocks, tolerance, memory, pairs);
  for (const auto& [low, high] : pairs)
    count_corners(low, high), count_corners(high, low);
  return counts;
}

bool may_scale_masses(const Model& model) {
  const Blocks& blocks = model.blocks;
  if (!model.settings.mass_scaling || !model.loads.quiet_sides.empty())
    return false;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      return true;
  return false;
}

void begin_mass_scaling(Model& model) {
  Blocks& blocks = model.blocks;
  const Eigen::VectorXd critical = critical_steps(model);
  double mass = 0.0, stiffness = 0.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b)) {
      mass += blocks.mass[b];
      stiffness += blocks.mass[b] / (critical[b] * critical[b]);
    }
  const double dt = std::sqrt(mass / stiffness);
  blocks.scale = Eigen::VectorXd::Ones(blocks.size());
  int smallest = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b)) {
      const double root = dt / critical[b];
      blocks.scale[b] = root * root;
      multiply_motion(blocks, b, 1.0 / root);
      if (smallest < 0 || critical[b] < critical[smallest])
        smallest = b;
    }
  model.time_step = {dt, smallest, blocks.size(), false, false};
  count_time_from_here(model);
}

void end_mass_scaling(Model& model) {
  Blocks& blocks = model.blocks;
  if (!blocks.has_scaled_masses())
    return;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      multiply_motion(blocks, b, std::sqrt(blocks.scale[b]));
  blocks.scale.resize(0);
  model.time_step = choose_time_step(model);
  count_time_from_here(model);
}

MassFactors mass_factors(const Blocks& blocks) {
  MassFactors factors;
  if (!blocks.has_scaled_masses())
    return factors;
  bool first = true;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const double scale = blocks.scale[b];
    factors.least = first ? scale : std::min(factors.least, scale);
    factors.largest = first ? scale : std::max(factors.largest, scale);
    first = false;
  }
  return factors;
}

}  // namespace blocks::dynamics
