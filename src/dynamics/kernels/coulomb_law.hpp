// The law of JOINT: a linear normal spring, the strength of Mohr and Coulomb, and
// dilation that is a function of the slip (docs/laws.md#mohr-coulomb).
#pragma once

#include "dynamics/kernels/joint_strength.hpp"

namespace blocks::dynamics {

/// Returns by how much dilation has opened the joint, [L].
template <class Number>
[[gnu::always_inline]] inline Number opening(const LawValues<Number>& law,
                                             const Number& slip) {
  const Number length = magnitude(slip);
  return law.dilation * (length < law.dilation_limit ? length : law.dilation_limit);
}

/// Advances `state` by one step and computes `force`, [F]. may_start: false if
/// motion.starting is known to be 0. friction_only: there is no strength but friction
/// and no dilation, and the contact is not bonded. The result has the same bits then,
/// but the code is shorter.
template <bool may_start = true, bool friction_only = false, class Number>
[[gnu::always_inline]] inline void
apply_coulomb(const LawValues<Number>& law, double dt,
              const ContactMotion<Number>& motion, ContactState<Number>& state,
              ContactForce<Number>& force) {
  const Closing<Number> closing = closing_of<may_start>(dt, motion, state);
  const Number spring =
      state.normal + closing.share * state.stiffness * closing.advance;
  state.normal = state.bonded > 0.0 ? spring : positive(spring);
  if constexpr (may_start) {
    const Number max_spring = state.stiffness * closing.max_closure;
    const Number capped = state.normal < max_spring ? state.normal : max_spring;
    state.normal = closing.begins > 0.0 ? capped : state.normal;
  }
  if constexpr (friction_only) {
    apply_friction(law, dt, closing.share, motion, state, force);
    return;
  }
  const Number before = opening(law, state.slip);
  apply_strength(law, dt, closing.share, motion, state, force);
  // What the joint has risen presses from the next step on. Sliding back takes it back.
  const Number rise = opening(law, state.slip) - before;
  const Number pressed = state.normal + state.stiffness * rise;
  state.normal = state.bonded > 0.0 ? pressed : positive(pressed);
  state.offset = state.offset + rise;
}

/// Returns the elastic energy of the normal spring, [F L] >= 0.
template <class Number>
[[gnu::always_inline]] inline Number coulomb_energy(const ContactState<Number>& state) {
  return state.normal * state.normal / (2.0 * state.stiffness);
}

}  // namespace blocks::dynamics
