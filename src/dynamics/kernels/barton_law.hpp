// The law of BARTON: the hyperbolic closure of Bandis, and the strength of Barton,
// whose roughness is mobilised and worn by the slip (docs/laws.md#barton-bandis).
#pragma once

#include "dynamics/kernels/joint_strength.hpp"
#include "dynamics/kernels/log_and_tan.hpp"

namespace blocks::dynamics {

/// The closure of Bandis as a force, F = k V / (1 - V / vm), continued along its
/// tangent beyond a closure of `linear_from`.
template <class Number> struct BandisClosure {
  Number stiffness;    ///< [F/L] k = kni L
  Number largest;      ///< [L] vm
  Number linear_from;  ///< [L] less than vm; 0: F = k V
  Number slope, edge;  ///< [F/L], [F] tangent and force at linear_from

  [[gnu::always_inline]] BandisClosure(const LawValues<Number>& law,
                                       const Number& length, const Number& k)
      : stiffness(k), largest(law.largest_closure),
        linear_from(length > 0.0 ? law.linear_from : Number{}) {
    const Number left = 1.0 - linear_from / largest;
    edge = k * linear_from / left;
    slope = k / (left * left);
  }
  /// Returns the closure for a force >= 0.
  [[gnu::always_inline]] Number closure(const Number& force) const {
    const Number linear = force / stiffness;
    const Number curved = linear / (1.0 + linear / largest);
    const Number straight = linear_from + (force - edge) / slope;
    return force > edge ? straight : curved;
  }
  /// Returns the force for a closure >= 0.
  [[gnu::always_inline]] Number force(const Number& closure) const {
    const Number curved = stiffness * closure / (1.0 - closure / largest);
    const Number straight = edge + slope * (closure - linear_from);
    return closure > linear_from ? straight : curved;
  }
  /// Returns the energy of a closure, [F L]: the integral of the force.
  [[gnu::always_inline]] Number energy(const Number& closure) const {
    const Number bent = closure < linear_from ? closure : linear_from;
    const Number beyond = closure - bent;
    const Number x = bent / (largest - bent);
    return stiffness * largest * largest * closure_integral(x) +
           beyond * (edge + 0.5 * slope * beyond);
  }
};

/// Returns the part of the roughness that is mobilised, JRCm / JRC, at a slip of `u`
/// peak slips, u >= 0.3 (Barton, Bandis and Bakhtar 1985).
template <class Number>
[[gnu::always_inline]] inline Number mobilised(const Number& u) {
  const Number none = Number{};
  const Number worn = 0.5 - (u - 10.0) * (0.5 / 90.0);
  Number part = u < 100.0 ? worn : none;
  part = u < 10.0 ? 0.7 - (u - 4.0) * (0.2 / 6.0) : part;
  part = u < 4.0 ? 0.85 - (u - 2.0) * (0.15 / 2.0) : part;
  part = u < 2.0 ? 1.0 - (u - 1.0) * 0.15 : part;
  part = u < 1.0 ? 0.75 + (u - 0.6) * (0.25 / 0.4) : part;
  return u < 0.6 ? (u - 0.3) * (0.75 / 0.3) : part;
}

/// The strength of a rough joint.
template <class Number> struct RoughStrength {
  Number limit;  ///< [F]
  Number angle;  ///< radians that roughness adds; less than 0 before it is mobilised
};

/// Returns the strength at a slip of `u` peak slips under the force `normal` on a face
/// of `length`. The angle that roughness adds is -phi_r without slip, and 0 at 0.3 peak
/// slips.
template <class Number>
[[gnu::always_inline]] inline RoughStrength<Number>
rough_strength(const LawValues<Number>& law, const Number& length, const Number& normal,
               const Number& u) {
  constexpr double per_degree = 0.017453292519943295769;  // radians
  constexpr double largest_angle = 70.0 * per_degree;
  constexpr double largest_ratio = 1e300;  // of JCS to the stress, for stresses near 0
  const Number whole = Number{} + 1.0;
  const Number stress_ratio = law.wall_strength * length / normal;
  const Number above = stress_ratio > 1.0 ? stress_ratio : whole;
  const Number bounded = above < largest_ratio ? above : Number{} + largest_ratio;
  const Number peak = law.roughness * per_degree * log10_of(bounded);
  const Number rough = peak * mobilised(u);
  const Number max_rough = largest_angle - law.residual_angle;
  const Number limited = rough < max_rough ? rough : max_rough;
  const Number unmobilised = law.residual_angle * (u * (1.0 / 0.3) - 1.0);
  const Number angle = u < 0.3 ? unmobilised : limited;
  const Number total = positive(Number(law.residual_angle + angle));
  return {normal * tan_of(total) * law.strength_share, angle};
}

/// Advances `state` by one step and computes `force`, [F]. state.closure becomes V, the
/// closure of Bandis, which follows from state.normal; state.plastic is the opening by
/// dilation, which is part of state.offset. A contact without a face
/// (length 0) has a linear spring and the friction tan(phi_r). may_start: false if
/// motion.starting is known to be 0.
template <bool may_start = true, class Number>
[[gnu::always_inline]] inline void apply_barton(const LawValues<Number>& law, double dt,
                                                const ContactMotion<Number>& motion,
                                                ContactState<Number>& state,
                                                ContactForce<Number>& force) {
  const Number none = Number{}, whole = none + 1.0;
  // There is no strength that could be lost.
  state.bonded = none, state.failed = whole;

  const Closing<Number> closing = closing_of<may_start>(dt, motion, state);
  const BandisClosure<Number> bandis(law, state.length, state.stiffness);
  const Number before = bandis.closure(state.normal);
  Number closure = positive(Number(before + closing.share * closing.advance));
  if constexpr (may_start) {
    const Number capped = closure < closing.max_closure ? closure : closing.max_closure;
    closure = closing.begins > 0.0 ? capped : closure;
  }
  // A spring at rest is not computed again, so that it does not drift by rounding.
  state.normal = closure == before ? state.normal : bandis.force(closure);
  force.normal = positive(Number(state.normal + motion.damping * motion.closing));

  const Number trial = trial_shear(dt, closing.share, motion, state);
  const Number bent = magnitude(trial) / state.shear_stiffness;
  const Number moved = state.path + (state.shear_stiffness > 0.0 ? bent : none);
  const RoughStrength<Number> rough =
      rough_strength(law, state.length, force.normal, Number(moved / law.peak_slip));
  const Number dashpot = motion.damping * motion.sliding;
  const Shear<Number> shear =
      limit_shear(trial, rough.limit, dashpot, state.shear_stiffness);
  const Number distance = magnitude(state.slip);
  state.shear = shear.spring;
  force.shear = shear.force;
  state.slip = state.slip + shear.slip;
  state.path = state.path + magnitude(shear.slip);

  // Asperities lift the joint by half the angle that they add. On the way back to where
  // the slip began, the joint closes in proportion to the distance.
  const Number farther = magnitude(state.slip) - distance;
  const Number opens = small_tan(Number(0.5 * positive(rough.angle))) * farther;
  const Number closes = state.plastic / distance * farther;
  const Number rise = farther < 0.0 ? closes : opens;
  state.plastic = state.plastic + rise;
  state.closure = positive(Number(closure + rise));
  const Number pressed = bandis.force(state.closure);
  state.normal = rise == 0.0 ? state.normal : pressed;
  state.offset = state.offset + rise;
}

/// Returns the elastic energy of the normal spring, [F L] >= 0.
template <class Number>
[[gnu::always_inline]] inline Number barton_energy(const LawValues<Number>& law,
                                                   const ContactState<Number>& state) {
  const BandisClosure<Number> bandis(law, state.length, state.stiffness);
  return bandis.energy(bandis.closure(state.normal));
}

}  // namespace blocks::dynamics
