// The force-displacement law of one contact, a small pure function (report 2.5,
// (16)-(18)). It departs from the printed (16): docs/departures.md#contact-law.
#pragma once

namespace blocks::dynamics {

/// Constants of the law. [F] force, [L] length, [T] time.
struct ContactLaw {
  double normal_stiffness;  ///< [F/L] Kn
  double shear_stiffness;   ///< [F/L] Ks
  double friction;          ///< mu
  double dt;                ///< [T]
};

/// Advances the springs FN >= 0 and FS, which are kept from step to step. Computes the
/// acting forces, including the dashpots: Fn >= 0 in compression, and |Fs| <= mu Fn,
/// all [F].
/// closing, sliding: relative velocity of the corner against the edge, inwards and
/// along the edge, from its start to its end [L/T]; overlap: depth [L] >= 0; damping: C
/// of (18) [F T/L]; starting: 1 if the contact did not act in the step before or has
/// received a spring in this step, otherwise 0; may_start: false if `starting` is known
/// to be 0. A Number is a number of one contact, or of all lanes of a vector
/// (simd.hpp), so the function has no branches. It is always inlined, so that code for
/// one instruction set never runs on a processor without it.
template <bool may_start = true, class Number>
[[gnu::always_inline]] inline void apply(const ContactLaw& law, Number& normal_elastic,
                                         Number& shear_elastic, const Number& closing,
                                         const Number& sliding, const Number& overlap,
                                         const Number& damping, const Number& starting,
                                         Number& normal_force, Number& shear_force) {
  const Number none = Number{}, whole = none + 1.0;
  // b. In its first step a contact has closed by its overlap, not by a whole step. A
  // spring that it has received is limited to Kn times the overlap.
  const Number advance = closing * law.dt;
  Number share = whole;
  if constexpr (may_start) {
    const Number part = overlap / advance;
    const Number first_share = advance > overlap ? part : whole;
    share = starting > 0.0 ? first_share : whole;
  }
  const Number spring = normal_elastic + share * law.normal_stiffness * advance;
  normal_elastic = spring > 0.0 ? spring : none;
  if constexpr (may_start) {
    const Number most = law.normal_stiffness * overlap;
    const Number capped = normal_elastic < most ? normal_elastic : most;
    normal_elastic = starting > 0.0 ? capped : normal_elastic;
  }

  // c. There is no tension. The dashpot is added to the force, but not to the spring.
  const Number damped = normal_elastic + damping * closing;
  normal_force = damped > 0.0 ? damped : none;

  // d. Coulomb friction (17). A sliding contact has no dashpot in shear.
  const Number limit = law.friction * normal_force;
  const Number trial = shear_elastic + share * law.shear_stiffness * sliding * law.dt;
  const Number below = trial < limit ? trial : limit;
  const Number held = below > -limit ? below : -limit;
  const Number with_dashpot = held + damping * sliding;
  const Number less = with_dashpot < limit ? with_dashpot : limit;
  const Number clamped = less > -limit ? less : -limit;
  shear_elastic = held;
  shear_force = held == trial ? clamped : held;
}

}  // namespace blocks::dynamics
