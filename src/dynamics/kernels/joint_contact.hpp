// The quantities of one contact with the law of a joint, as its law sees them
// (docs/laws.md). A Number is a number of one contact, or of all lanes of a vector.
#pragma once

#include "model/joint_state.hpp"

namespace blocks::dynamics {

/// The values of JointLaw of one contact. [F] force, [L] length.
template <class Number> struct LawValues {
  Number friction, cohesion, tension;  ///< coefficient, [F/L^2]
  Number residual_friction, residual_cohesion, residual_tension;
  Number dilation, dilation_limit;  ///< tangent, [L]
  /// Walton: K2 / K1 = 1 / e^2
  Number unloading_ratio;
  /// Barton: JRC, JCS [F/L^2], phi_r in radians (at most 70 degrees), upeak [L]
  Number roughness, wall_strength, residual_angle, peak_slip;
  /// Bandis: vm [L]; vm (1 - sqrt(kni / knmax)) [L], where the tangent reaches knmax
  Number largest_closure, linear_from;
  /// Barton: JointLaw::strength_share
  Number strength_share;
};

/// How the two blocks move at a contact in this step.
template <class Number> struct ContactMotion {
  Number closing,
      sliding;      ///< [L/T] inwards; along the edge, from its start to its end
  Number overlap;   ///< [L] >= 0
  Number damping;   ///< [F T/L] C of (18)
  Number starting;  ///< 1 in the first step of the contact or after a transfer, else 0
};

/// The state of a contact, advanced by its law. See JointState; flags are 1 or 0. The
/// step sets `length` before the law acts.
template <class Number> struct ContactState {
  Number normal, shear;  ///< [F] FN, FS of the springs
#define BLOCKS_MEMBER(member, ...) Number member;
  BLOCKS_JOINT_STATES(BLOCKS_MEMBER)
#undef BLOCKS_MEMBER
};

/// The forces of a contact in this step, dashpots included, [F].
template <class Number> struct ContactForce { Number normal, shear; };

}  // namespace blocks::dynamics
