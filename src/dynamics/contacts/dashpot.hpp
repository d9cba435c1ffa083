// The dashpot constant (18), C = 2 DAMPING sqrt(Kn m), [F T/L]
// (docs/theory.md#damping).
#pragma once

#include <cmath>

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns C for a corner against a plane or a fixed block, both of which have infinite
/// mass.
inline double damping_against_fixed(const Settings& settings, double mass) {
  return settings.damping * 2.0 * std::sqrt(settings.normal_stiffness * mass);
}

/// Returns C for two blocks, m = m1 m2 / (m1 + m2), with their inertial masses. At
/// least one of them is free.
inline double contact_damping(const Settings& settings, const Blocks& blocks, int a,
                              int b) {
  const double ma = blocks.inertial_mass(a), mb = blocks.inertial_mass(b);
  const double mass = !blocks.is_free(a)   ? mb
                      : !blocks.is_free(b) ? ma
                                           : ma * mb / (ma + mb);
  return damping_against_fixed(settings, mass);
}

}  // namespace blocks::dynamics
