// What the laws of joints have in common: when a contact closes for the first time,
// the strength of Mohr and Coulomb with its loss, and the shear spring
// (docs/laws.md#mohr-coulomb). A Number is a number of one contact, or of all lanes of
// a vector, so the functions have no branches.
#pragma once

#include <type_traits>

#include "dynamics/kernels/joint_contact.hpp"

namespace blocks::dynamics {

template <class Number>
[[gnu::always_inline]] inline Number magnitude(const Number& x) {
  return x < 0.0 ? -x : x;
}
/// Returns x, or 0 if x < 0. The result is never -0.
template <class Number> [[gnu::always_inline]] inline Number positive(const Number& x) {
  return x > 0.0 ? x : Number{};
}

/// Returns whether a comparison holds in any lane.
template <class Comparison>
[[gnu::always_inline]] inline bool holds_in_any_lane(const Comparison& yes) {
  if constexpr (std::is_same_v<Comparison, bool>) {
    return yes;
  } else {
    constexpr int lanes = sizeof(Comparison) / sizeof(double);
    typedef signed char Marks __attribute__((vector_size(lanes)));
    const Marks marks = __builtin_convertvector(yes, Marks);
    unsigned long long word = 0;
    __builtin_memcpy(&word, &marks, lanes);
    return word != 0;
  }
}

/// The closing of a contact in a step.
template <class Number> struct Closing {
  Number advance;      ///< [L] closing dt
  Number share;        ///< q: the part of the step in which the contact acts, 0 to 1
  Number max_closure;  ///< [L] of the first step: overlap + offset
  Number begins;       ///< 1 if the first step's rules apply, else 0
};

/// In its first step a contact has closed by its overlap, not by a whole step. A bonded
/// contact acts from the start of its first step. may_start: false if `starting` is
/// known to be 0.
template <bool may_start, class Number>
[[gnu::always_inline]] inline Closing<Number>
closing_of(double dt, const ContactMotion<Number>& motion,
           const ContactState<Number>& state) {
  const Number none = Number{}, whole = none + 1.0;
  Closing<Number> closing = {motion.closing * dt, whole, motion.overlap + state.offset,
                             none};
  if constexpr (may_start) {
    closing.begins = state.bonded > 0.0 ? none : motion.starting;
    if (holds_in_any_lane(closing.begins > 0.0)) {
      const Number part = closing.max_closure / closing.advance;
      const Number first_share = closing.advance > closing.max_closure ? part : whole;
      closing.share = closing.begins > 0.0 ? first_share : whole;
    }
  }
  return closing;
}

/// The shear spring at the end of a step.
template <class Number> struct Shear {
  Number spring;  ///< [F] FS, |FS| <= limit
  Number force;   ///< [F] with the dashpot, unless the contact slides
  Number slip;    ///< [L] slip in this step, with its sign
};

/// Limits the shear spring `trial` to `limit` >= 0, and slides by the rest.
template <class Number>
[[gnu::always_inline]] inline Shear<Number>
limit_shear(const Number& trial, const Number& limit, const Number& dashpot,
            const Number& stiffness) {
  const Number below = trial < limit ? trial : limit;
  const Number held = below > -limit ? below : -limit;
  const Number with_dashpot = held + dashpot;
  const Number less = with_dashpot < limit ? with_dashpot : limit;
  const Number clamped = less > -limit ? less : -limit;
  Number slip = Number{};
  if (holds_in_any_lane(held != trial)) {
    const Number part = (trial - held) / stiffness;
    slip = stiffness > 0.0 ? part : slip;
  }
  return {held, held == trial ? clamped : held, slip};
}

/// Limits the tension of a failed contact to the residual strength. A contact without
/// one loses its bond.
template <class Number>
[[gnu::always_inline]] inline void release(const LawValues<Number>& law,
                                           ContactState<Number>& state) {
  const Number none = Number{}, min_normal = -(law.residual_tension * state.length);
  const Number held = state.normal > min_normal ? state.normal : min_normal;
  const Number bonded = law.residual_tension > 0.0 ? state.bonded : none;
  state.normal = state.failed > 0.0 ? held : state.normal;
  state.bonded = state.failed > 0.0 ? bonded : state.bonded;
  state.normal = state.bonded > 0.0 ? state.normal : positive(state.normal);
}

/// Returns the shear spring at the end of the step if it does not slip, [F].
template <class Number>
[[gnu::always_inline]] inline Number trial_shear(double dt, const Number& share,
                                                 const ContactMotion<Number>& motion,
                                                 const ContactState<Number>& state) {
  return state.shear + share * state.shear_stiffness * motion.sliding * dt;
}

/// Computes the forces of the advanced normal spring `state.normal` if there is no
/// strength but friction, and advances the shear spring.
template <class Number>
[[gnu::always_inline]] inline void
apply_friction(const LawValues<Number>& law, double dt, const Number& share,
               const ContactMotion<Number>& motion, ContactState<Number>& state,
               ContactForce<Number>& force) {
  force.normal = positive(Number(state.normal + motion.damping * motion.closing));
  const Shear<Number> shear = limit_shear(
      trial_shear(dt, share, motion, state), Number(law.friction * force.normal),
      Number(motion.damping * motion.sliding), state.shear_stiffness);
  state.shear = shear.spring;
  force.shear = shear.force;
}

/// Applies the strengths of Mohr and Coulomb to the advanced normal spring
/// `state.normal`, and advances the shear spring. The strength in tension is tested
/// first. A contact that fails gets its residual values in the same step.
template <class Number>
[[gnu::always_inline]] inline void
apply_strength(const LawValues<Number>& law, double dt, const Number& share,
               const ContactMotion<Number>& motion, ContactState<Number>& state,
               ContactForce<Number>& force) {
  const Number whole = Number{} + 1.0;
  const Number tension = state.failed > 0.0 ? law.residual_tension : law.tension;
  const Number min_normal = -(tension * state.length);
  state.failed = state.normal < min_normal ? whole : state.failed;

  const Number trial = trial_shear(dt, share, motion, state);
  const Number dashpot = motion.damping * motion.sliding;
  const auto limited = [&](Shear<Number> & shear) __attribute__((always_inline)) {
    release(law, state);
    const Number damped = state.normal + motion.damping * motion.closing;
    force.normal = state.bonded > 0.0 ? damped : positive(damped);
    const Number cohesion = state.failed > 0.0 ? law.residual_cohesion : law.cohesion;
    const Number friction = state.failed > 0.0 ? law.residual_friction : law.friction;
    const Number limit =
        positive(Number(cohesion * state.length + friction * force.normal));
    shear = limit_shear(trial, limit, dashpot, state.shear_stiffness);
    state.failed = shear.spring == trial ? state.failed : whole;
  };
  Shear<Number> shear;
  const Number failed = state.failed;
  limited(shear);
  // The second time has residual values where shear failed, and is the same elsewhere.
  if (holds_in_any_lane(failed < state.failed))
    limited(shear);
  state.shear = shear.spring;
  force.shear = shear.force;
  state.slip = state.slip + shear.slip;
  state.path = state.path + magnitude(shear.slip);
}

/// Returns the energy of a shear spring, [F L].
template <class Number>
[[gnu::always_inline]] inline Number shear_energy(const ContactState<Number>& state) {
  const Number energy = state.shear * state.shear / (2.0 * state.shear_stiffness);
  return state.shear_stiffness > 0.0 ? energy : Number{};
}

}  // namespace blocks::dynamics
