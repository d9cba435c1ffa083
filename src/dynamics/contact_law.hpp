// The force-displacement law of one contact, a small pure function (report 2.5,
// (16)-(18), rule 7). Departs from the printed (16): docs/departures.md.
#pragma once

namespace blocks::dynamics {

/// Constants of the law. [F] force, [L] length, [T] time.
struct ContactLaw {
  double normal_stiffness;  ///< [F/L] Kn
  double shear_stiffness;   ///< [F/L] Ks
  double friction;          ///< mu
  double dt;                ///< [T]
};

/// Advances the springs FN >= 0 and FS, which are carried from step to step, and gives
/// the acting forces, springs and dashpots: Fn >= 0, compression, and |Fs| <= mu Fn,
/// all [F].
/// closing, sliding: relative velocity of the corner against the edge, inwards and
/// along the edge [L/T]; overlap: depth [L] > 0; damping: C of (18) [F T/L]; starting:
/// 1 if the contact did not act in the step before, or was handed a force in this one,
/// else 0. No branches, for it runs in SIMD lanes; inlined wherever it is used, so that
/// no instruction set leaks into another's code.
[[gnu::always_inline]] inline void apply(const ContactLaw& law, double& normal_elastic,
                                         double& shear_elastic, double closing,
                                         double sliding, double overlap, double damping,
                                         double starting, double& normal_force,
                                         double& shear_force) {
  // b. On its first step a contact has closed by the overlap, not by a whole step; with
  // what it was handed it is no stronger than its overlap explains.
  const double advance = closing * law.dt;
  const double part = overlap / advance, most = law.normal_stiffness * overlap;
  const double share = starting > 0.0 ? (advance > overlap ? part : 1.0) : 1.0;
  const double spring = normal_elastic + share * law.normal_stiffness * advance;
  const double pressed = spring > 0.0 ? spring : 0.0;
  const double capped = pressed < most ? pressed : most;
  normal_elastic = starting > 0.0 ? capped : pressed;

  // c. No tension. The dashpot is added, never stored.
  const double damped = normal_elastic + damping * closing;
  normal_force = damped > 0.0 ? damped : 0.0;

  // d. Coulomb friction (17); no dashpot while it slides.
  const double limit = law.friction * normal_force;
  const double trial = shear_elastic + share * law.shear_stiffness * sliding * law.dt;
  const double below = trial < limit ? trial : limit;
  const double held = below > -limit ? below : -limit;
  const double with_dashpot = held + damping * sliding;
  const double less = with_dashpot < limit ? with_dashpot : limit;
  const double clamped = less > -limit ? less : -limit;
  shear_elastic = held;
  shear_force = held == trial ? clamped : held;
}

}  // namespace blocks::dynamics
