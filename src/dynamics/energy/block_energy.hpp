// The energies of one block: pure functions (docs/laws.md#energy).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// The motion of a block.
struct BlockMotion {
  Vec2 velocity;   ///< [L/T]
  double spin;     ///< 1/T
  double rate[3];  ///< 1/T strain rates 11, 22, 12
};
/// The masses of a block that belong to the velocities of BlockMotion.
struct BlockMasses {
  double mass, inertia;  ///< [M], [M L^2]
  /// [M L^2] A times the components 11, 22, 12 of the effective mass of strain rates
  double strain[3];
};

/// Returns the present motion of block b. The strain rates of a rigid block are 0.
inline BlockMotion motion_of(const Blocks& blocks, int b) {
  const auto rate = blocks.strain_rate.col(b);
  return {blocks.velocity.col(b), blocks.spin[b], {rate[0], rate[3], rate[1]}};
}
/// Returns the inertial masses of block b with its present shape. MSCALE scales them
/// during SOLVE.
BlockMasses masses_of(const Blocks& blocks, int b, bool rigid);
/// Turns strain rates of block b back by its motion in the last step, which has turned
/// them.
BlockMotion turned_back(const BlockMotion& motion, double dt);

/// Returns half the sum of mass times a times b. If a = b, this is the kinetic energy,
/// [F L].
inline double kinetic_energy(const BlockMasses& masses, const BlockMotion& a,
                             const BlockMotion& b) {
  double twice =
      masses.mass * a.velocity.dot(b.velocity) + masses.inertia * (a.spin * b.spin);
  // The trace of a m b, with the tensors a, b of the rates and m of the masses.
  const auto [a11, a22, a12] = a.rate;
  const auto [b11, b22, b12] = b.rate;
  const auto [m11, m22, m12] = masses.strain;
  twice += m11 * (a11 * b11 + a12 * b12) + m22 * (a22 * b22 + a12 * b12) +
           m12 * (a11 * b12 + a12 * b11 + a12 * b22 + a22 * b12);
  return 0.5 * twice;
}

/// The energies of a block in its present state, [F L].
struct BlockEnergy {
  double kinetic = 0.0;  ///< 0 for blocks that are not free
  double strain = 0.0;   ///< of the stress; 0 for rigid and removed blocks
};
BlockEnergy energy_of(const Model& model, int b);
double kinetic_energy(const Blocks& blocks, int b, bool rigid);
double strain_energy(const Model& model, int b);

/// Returns the work of the stress of block b on its strain rates in dt, [F L].
double stress_work(const Blocks& blocks, int b, double dt);
/// Returns the work of the stress of block b in the last step, in which it has grown
/// by the elastic moduli times the strain rates, [F L].
double last_stress_work(const Model& model, int b);

}  // namespace blocks::dynamics
