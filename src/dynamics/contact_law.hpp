// The force-displacement law of one contact, a small pure function (report 2.5,
// (16)-(18), rule 7). Departs from the printed (16): docs/departures.md.
#pragma once

#include <algorithm>

namespace blocks::dynamics {

/// Constants of the law. [F] force, [L] length, [T] time.
struct ContactLaw {
  double normal_stiffness;  ///< [F/L] Kn
  double shear_stiffness;   ///< [F/L] Ks
  double friction;          ///< mu
  double dt;                ///< [T]
};

/// Spring forces carried from step to step.
struct ElasticForce {
  double normal = 0.0;  ///< [F] FN >= 0
  double shear = 0.0;   ///< [F] FS
};

/// Forces that act: springs and dashpots.
struct ContactForce {
  double normal = 0.0;  ///< [F] Fn >= 0, compression
  double shear = 0.0;   ///< [F] Fs, |Fs| <= mu Fn
};

/// Advances the springs and returns the acting forces.
/// closing, sliding: relative velocity of the corner against the edge, inwards and
/// along the edge [L/T]; overlap: depth [L] > 0; damping: C of (18) [F T/L]; starting:
/// the contact did not act in the step before, or was handed a force in this one.
inline ContactForce apply(const ContactLaw& law, ElasticForce& spring, double closing,
                          double sliding, double overlap, double damping,
                          bool starting) {
  // b. On its first step a contact has closed by the overlap, not by a whole step.
  const double advance = closing * law.dt;
  const double share = starting && advance > overlap ? overlap / advance : 1.0;
  spring.normal = std::max(0.0, spring.normal + share * law.normal_stiffness * advance);
  if (starting)  // with what it was handed no stronger than its overlap explains
    spring.normal = std::min(spring.normal, law.normal_stiffness * overlap);

  // c. No tension. The dashpot is added, never stored.
  const double normal = std::max(0.0, spring.normal + damping * closing);

  // d. Coulomb friction (17); no dashpot while it slides.
  const double limit = law.friction * normal;
  const double trial = spring.shear + share * law.shear_stiffness * sliding * law.dt;
  spring.shear = std::clamp(trial, -limit, limit);
  const bool slipped = spring.shear != trial;
  const double shear =
      slipped ? spring.shear
              : std::clamp(spring.shear + damping * sliding, -limit, limit);
  return {normal, shear};
}

}  // namespace blocks::dynamics
