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
BlockMotion motion_of(const Blocks& blocks, int b);
/// Returns the inertial masses of block b with its present shape. MSCALE scales them
/// during SOLVE.
BlockMasses masses_of(const Blocks& blocks, int b, bool rigid);
/// Turns strain rates of block b back by its motion in the last step, which has turned
/// them.
BlockMotion turned_back(const BlockMotion& motion, double dt);

/// Returns half the sum of mass times a times b. If a = b, this is the kinetic energy,
/// [F L].
double kinetic_energy(const BlockMasses& masses, const BlockMotion& a,
                      const BlockMotion& b);

/// Returns the strain energy of the stress of block b, [F L].
double strain_energy(const Blocks& blocks, int b, const Material& material);
/// Returns the work of the stress of block b on its strain rates in dt, [F L].
double stress_work(const Blocks& blocks, int b, double dt);
/// Returns the work of the stress of block b in the last step, in which it has grown
/// by the elastic moduli times the strain rates, [F L].
double last_stress_work(const Blocks& blocks, int b, const Material& material,
                        double dt);

}  // namespace blocks::dynamics
