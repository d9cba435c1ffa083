// The law of WALTON: a normal spring that unloads and reloads more steeply than it
// loads, and the strength of Mohr and Coulomb in shear (docs/laws.md#walton).
#pragma once

#include "dynamics/kernels/joint_strength.hpp"

namespace blocks::dynamics {

/// Advances `state` by one step and computes `force`, [F]. state.closure is a, the sum
/// of the closing, and state.plastic is a0, the closure at which the force is 0 when
/// the contact unloads; both are 0 when a contact starts. While a < a0 the contact has
/// no force but remembers a and a0. may_start: false if motion.starting is known to be
/// 0. Dilation and tension are not used.
template <bool may_start = true, class Number>
[[gnu::always_inline]] inline void apply_walton(const LawValues<Number>& law, double dt,
                                                const ContactMotion<Number>& motion,
                                                ContactState<Number>& state,
                                                ContactForce<Number>& force) {
  const Closing<Number> closing = closing_of<may_start>(dt, motion, state);
  const Number loading = state.stiffness, unloading = loading * law.unloading_ratio;
  const Number max_spring = loading * closing.max_closure;
  if constexpr (may_start) {
    // A received spring lies on or below the line of first loading.
    const Number capped = state.normal < max_spring ? state.normal : max_spring;
    const Number normal = closing.begins > 0.0 ? capped : state.normal;
    const Number min_closure = normal / loading;
    const Number closure = state.closure > min_closure ? state.closure : min_closure;
    state.normal = normal;
    state.closure = motion.starting > 0.0 ? closure : state.closure;
  }
  const Number advance = closing.share * closing.advance;
  state.closure = state.closure + advance;
  // With a force, a0 follows from it, also if the stiffness has grown.
  const Number reached = unloading * (state.closure - state.plastic);
  const Number elastic =
      state.normal > 0.0 ? state.normal + unloading * advance : reached;
  const Number first = loading * state.closure;
  Number spring = elastic < first ? elastic : first;
  if constexpr (may_start) {
    const Number capped = spring < max_spring ? spring : max_spring;
    spring = closing.begins > 0.0 ? capped : spring;
  }
  const Number plastic = state.closure - spring / unloading;
  state.plastic = spring > 0.0 ? plastic : state.plastic;
  state.normal = state.bonded > 0.0 ? spring : positive(spring);
  apply_strength(law, dt, closing.share, motion, state, force);
}

/// Returns the elastic energy of the normal spring, [F L] >= 0.
template <class Number>
[[gnu::always_inline]] inline Number walton_energy(const LawValues<Number>& law,
                                                   const ContactState<Number>& state) {
  const Number unloading = state.stiffness * law.unloading_ratio;
  return state.normal * state.normal / (2.0 * unloading);
}

}  // namespace blocks::dynamics
