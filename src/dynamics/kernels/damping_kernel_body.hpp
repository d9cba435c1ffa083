// Local damping of blocks (kernels.hpp, docs/rest.md#local-damping). Included once for
// each instruction set, in a namespace of its own.
#include "dynamics/kernels/corner_motion_body.hpp"
#include "dynamics/kernels/free_lanes_body.hpp"
#include "dynamics/kernels/inertial_mass_body.hpp"
#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Damps the strain rates of a pack of blocks. damping.alpha_dt is alpha times the time
/// step, [T]. Returns the work of the damping, [F L].
template <class Lanes>
BLOCKS_INLINE Pack damp_strain(const BlockColumns& blocks, const LocalDamping& damping,
                               Mask free, int b, Lanes lanes) {
  const Tensor stress = load_rows<4>(blocks.stress, b, lanes);
  const Tensor before = load_rows<4>(blocks.strain_rate, b, lanes);
  const Symmetric rate = symmetric(before);
  const Pack force = root(driving_stress(blocks, stress, b, lanes).square());
  const Pack speed = root(rate.square());
  const StrainMass mass(blocks, b, lanes);
  const Symmetric loss = mass.accelerations(damping.alpha_dt * force / speed * rate);
  const Mask moves = free & (speed > slow_motion * root(loss.square())) & (speed > 0.0);
  store_rows(blocks.strain_rate, b, lanes, select(moves, tensor(rate - loss), before));
  const Pack area = load(blocks.area + b, lanes);
  return moves ? damping.alpha_dt * area * force * speed : Pack{};
}

/// Damps the velocities and spins of a pack of blocks. damping.alpha_dt is alpha times
/// the time step, [T]. Returns the work of the damping, [F L].
template <class Lanes>
BLOCKS_INLINE Pack damp_velocities(const BlockColumns& blocks,
                                   const LocalDamping& damping, Mask free, int b,
                                   Lanes lanes) {
  const Pack mass = load(blocks.mass + b, lanes);
  const Points force = load_columns<2>(blocks.force, b, lanes);
  const Points velocity = load_columns<2>(blocks.velocity, b, lanes);
  const Pack acceleration = root(squared_norm(
      force / twice(mass) + everywhere(damping.gravity_x, damping.gravity_y)));
  const Pack speed = root(squared_norm(velocity));
  const Pack slowing = scaled(blocks, acceleration, b, lanes);
  const Mask moves =
      free & (speed > slow_motion * damping.alpha_dt * slowing) & (speed > 0.0);
  const Points loss = twice(damping.alpha_dt * slowing / speed);
  const Points slower = {velocity.part[0] - loss.part[0] * velocity.part[0],
                         velocity.part[1] - loss.part[1] * velocity.part[1]};
  store_columns(blocks.velocity, b, lanes, select(moves, slower, velocity));

  const Pack moment = absolute(load(blocks.moment + b, lanes));
  const Pack spin = load(blocks.spin + b, lanes);
  const Pack turning =
      scaled(blocks, moment / load(blocks.inertia + b, lanes), b, lanes);
  const Pack slows = damping.alpha_dt * turning;
  const Mask turns = free & (absolute(spin) > slow_motion * slows) & (spin != 0.0);
  store(blocks.spin + b, lanes, turns ? spin - (spin > 0.0 ? slows : -slows) : spin);
  const Pack work = moves ? damping.alpha_dt * mass * acceleration * speed : Pack{};
  return work + (turns ? damping.alpha_dt * moment * absolute(spin) : Pack{});
}

}  // namespace

void damp_unbalanced(const BlockColumns& blocks, const LocalDamping& damping,
                     bool rigid, int first, int last) {
  each_pack(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        Pack work = damp_velocities(blocks, damping, free, b, lanes);
        if (!rigid)
          work += damp_strain(blocks, damping, free, b, lanes);
        if (damping.work != nullptr)
          store(damping.work + b, lanes, work);
      });
}

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
