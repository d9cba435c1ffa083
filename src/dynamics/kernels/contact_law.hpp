// The law of contacts without the law of a joint: STIFF and FRICTN (report 2.5,
// (16)-(18)). It is the law of Mohr and Coulomb with friction only. It departs from the
// printed (16): docs/departures.md#contact-law.
#pragma once

#include "dynamics/kernels/coulomb_law.hpp"

namespace blocks::dynamics {

/// Constants of the law. [F] force, [L] length, [T] time.
struct ContactLaw {
  double normal_stiffness;  ///< [F/L] Kn
  double shear_stiffness;   ///< [F/L] Ks
  double friction;          ///< mu
  double dt;                ///< [T]
};

/// Returns the state of a contact with these springs, [F].
template <class Number>
[[gnu::always_inline]] inline ContactState<Number>
usual_state(const ContactLaw& law, const Number& normal, const Number& shear) {
  const Number none = Number{};
  ContactState<Number> state = {};
  state.normal = normal, state.shear = shear, state.failed = none + 1.0;
  state.stiffness = none + law.normal_stiffness;
  state.shear_stiffness = none + law.shear_stiffness;
  return state;
}

/// Advances `state` by one step and computes `force`, [F]: Fn >= 0 in compression, and
/// |Fs| <= mu Fn. may_start: false if motion.starting is known to be 0. It is always
/// inlined, so that code for one instruction set never runs on a processor without it.
template <bool may_start = true, class Number>
[[gnu::always_inline]] inline void
apply_usual(const ContactLaw& law, const ContactMotion<Number>& motion,
            ContactState<Number>& state, ContactForce<Number>& force) {
  LawValues<Number> values = {};
  values.friction = values.residual_friction = Number{} + law.friction;
  apply_coulomb<may_start, true>(values, law.dt, motion, state, force);
}

}  // namespace blocks::dynamics
