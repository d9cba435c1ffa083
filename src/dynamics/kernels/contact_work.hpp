// What one contact does with the work of its two blocks in one step: pure functions
// (docs/laws.md#energy). A Number is a number of one contact, or of all lanes of a
// vector, so the functions have no branches.
#pragma once

#include "dynamics/kernels/joint_strength.hpp"

namespace blocks::dynamics {

/// How contacts use the work that they take from the blocks, and the energy that their
/// springs store, [F L].
template <class Number> struct alignas(64) ContactWork {
  Number friction, dashpots, breaking, hysteresis;
  Number dilation;       ///< added to the normal spring; may be negative
  Number integration;    ///< error of the integration in time
  Number before, after;  ///< elastic energy before and after the step
};
/// Calls act(one.member, other.member, ...) for each member of ContactWork.
template <class Act, class... Works>
[[gnu::always_inline]] inline void each_work(const Act& act, Works&&... works) {
  act(works.friction...), act(works.dashpots...), act(works.breaking...);
  act(works.hysteresis...), act(works.dilation...), act(works.integration...);
  act(works.before...), act(works.after...);
}

/// A contact in one step. Forces are in [F], motions in [L], energies in [F L]. Flags
/// are 1 or 0.
template <class Number> struct ContactStep {
  Number closing, sliding;  ///< motions in the step
  Number share;             ///< part of the motions that loads the springs
  /// the normal spring before the step, and as it acts in the step
  Number normal_before, normal;
  Number shear_before, shear;        ///< the shear spring before and after the step
  Number normal_force, shear_force;  ///< with dashpots
  Number shear_compliance;           ///< [L/F] of the shear spring; 0: it has none
  /// stored by the normal spring before the step, as it acts, and after dilation
  Number normal_energy_before, normal_energy_acting, normal_energy;
  Number shear_energy_before, shear_energy;  ///< stored by the shear spring
  Number fails;                              ///< it loses its strength in this step
  Number tears;          ///< it opens against its residual tensile strength
  Number is_hysteretic;  ///< the normal spring is Walton's
};

/// Describes the step that took a contact from `before` to `after`. `before` has the
/// stiffnesses and the length of the step. normal_energy(state): that of its normal
/// spring.
template <class Number, class Energy>
[[gnu::always_inline]] inline ContactStep<Number>
step_of(double dt, const ContactMotion<Number>& motion,
        const ContactState<Number>& before, const ContactState<Number>& after,
        const ContactForce<Number>& force, const Number& is_hysteretic,
        const Energy& normal_energy) {
  const Number none = Number{}, whole = none + 1.0;
  // Dilation changes the spring after it has acted.
  const Number rise = after.offset - before.offset;
  const Number lowered = positive(Number(after.normal - after.stiffness * rise));
  const Number pressing = force.normal - motion.damping * motion.closing;
  const Number unbonded = force.normal > 0.0 ? pressing : lowered;
  const Number acting = after.bonded > 0.0 ? pressing : unbonded;
  ContactState<Number> in_step = after;
  in_step.normal = rise == 0.0 ? after.normal : acting;
  const Number compliance = 1.0 / after.shear_stiffness;
  const Number energy = normal_energy(after);
  Number energy_acting = energy;
  if (holds_in_any_lane(rise != 0.0))
    energy_acting = normal_energy(in_step);
  return {motion.closing * dt,
          motion.sliding * dt,
          closing_of<true>(dt, motion, before).share,
          before.normal,
          in_step.normal,
          before.shear,
          after.shear,
          force.normal,
          force.shear,
          after.shear_stiffness > 0.0 ? compliance : none,
          normal_energy(before),
          energy_acting,
          energy,
          shear_energy(before),
          shear_energy(after),
          after.failed > before.failed ? whole : none,
          acting < 0.0 ? after.failed * after.bonded : none,
          is_hysteretic};
}

/// Divides the work. It is that of the forces after the step of the springs on the
/// motion before it. The work of a spring is that of the mean of its forces before and
/// after; the rest is an error of the integration.
template <class Number>
[[gnu::always_inline]] inline ContactWork<Number>
work_of(const ContactStep<Number>& at) {
  const Number none = Number{};
  const Number added = at.normal - at.normal_before;
  const Number shear_added = at.shear - at.shear_before;
  const Number normal = 0.5 * (at.normal_before + at.normal);
  const Number shear = 0.5 * (at.shear_before + at.shear);
  // In its first step a contact moves farther than its springs.
  const Number idle = 1.0 - at.share;
  const Number error = 0.5 * added * at.closing + 0.5 * shear_added * at.sliding +
                       idle * (normal * at.closing + shear * at.sliding);
  const Number slip = at.share * at.sliding - shear_added * at.shear_compliance;
  const Number slid = shear * slip;
  const Number lost = at.share * (normal * at.closing) -
                      (at.normal_energy_acting - at.normal_energy_before);
  const Number torn = at.fails > 0.0 ? none : at.tears > 0.0 ? lost : none;
  const Number kept = at.fails > 0.0 ? none : at.tears > 0.0 ? none : lost;
  ContactWork<Number> work;
  work.friction = at.fails > 0.0 ? none : slid;
  work.dashpots = (at.normal_force - at.normal) * at.closing +
                  (at.shear_force - at.shear) * at.sliding;
  work.breaking = at.fails > 0.0 ? slid + lost : torn;
  work.hysteresis = at.is_hysteretic > 0.0 ? kept : none;
  work.dilation = at.normal_energy - at.normal_energy_acting;
  work.integration = error + (at.is_hysteretic > 0.0 ? none : kept);
  work.before = at.normal_energy_before + at.shear_energy_before;
  work.after = at.normal_energy + at.shear_energy;
  return work;
}

}  // namespace blocks::dynamics
