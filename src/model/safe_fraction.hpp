// The fraction of the critical time step (4) at which packed blocks are stable
// (docs/theory.md#time-step).
#pragma once

#include "model/model.hpp"

namespace blocks {

/// The number of contacts of a block for which the largest safe FRACTION is stated.
inline constexpr int usual_contacts = 8;

/// Returns the largest fraction of (4) at which a block with `contacts` contacts is
/// stable under DAMPING `damping`: (sqrt(1 + 3 n b^2) - b sqrt(3 n)) / sqrt(6 n). Local
/// damping alpha multiplies the force on a block that moves away from rest by 1 +
/// alpha. This multiplies n by 1 + alpha.
double safe_fraction(double damping, double local_damping = 0.0,
                     double contacts = usual_contacts);

/// Returns whether the deck leaves FRACTION to the program: it is blank or absent.
inline bool chooses_fraction(const Settings& settings) {
  return settings.fraction == 0.0;
}

/// Returns safe_fraction() for the damping in force.
double safe_fraction(const Settings& settings);

/// Returns TFRAC of FRACTION or, if the deck leaves it to the program, the safe
/// fraction for the damping in force and usual_contacts.
double fraction_in_force(const Settings& settings);

}  // namespace blocks
