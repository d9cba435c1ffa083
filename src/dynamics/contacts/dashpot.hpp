// The dashpot constant C of (18), damping 2 sqrt(Kn m), [F T/L]
// (docs/theory.md#damping).
#pragma once

#include <cmath>

#include "model/model.hpp"

namespace blocks::dynamics {

/// Of a corner against a plane or a fixed block, which have infinite mass.
inline double damping_against_fixed(const Settings& settings, double mass) {
  return settings.damping * 2.0 * std::sqrt(settings.normal_stiffness * mass);
}

/// Of two blocks, m = m1 m2 / (m1 + m2). At least one is free.
inline double contact_damping(const Settings& settings, const Blocks& blocks, int a,
                              int b) {
  const double ma = blocks.mass[a], mb = blocks.mass[b];
  const double mass = !blocks.is_free(a)   ? mb
                      : !blocks.is_free(b) ? ma
                                           : ma * mb / (ma + mb);
  return damping_against_fixed(settings, mass);
}

}  // namespace blocks::dynamics
