// The quantities of one contact with the law of a joint, as its law sees them
// (docs/laws.md). A Number is a number of one contact, or of all lanes of a vector.
#pragma once

#include "dynamics/kernels/law_values.hpp"
#include "model/law_state.hpp"

namespace blocks::dynamics {

/// How the two blocks move at a contact in this step.
template <class Number> struct ContactMotion {
  Number closing,
      sliding;      ///< [L/T] inwards; along the edge, from its start to its end
  Number overlap;   ///< [L] >= 0
  Number damping;   ///< [F T/L] C of (18)
  Number starting;  ///< 1 in the first step of the contact or after a transfer, else 0
};

/// The state of a contact, advanced by its law. See LawState; flags are 1 or 0. The
/// step sets `length` before the law acts.
template <class Number> struct ContactState {
  Number normal, shear;  ///< [F] FN, FS of the springs
#define BLOCKS_MEMBER(member, ...) Number member;
  BLOCKS_LAW_STATES(BLOCKS_MEMBER)
#undef BLOCKS_MEMBER
};

/// The forces of a contact in this step, dashpots included, [F].
template <class Number> struct ContactForce { Number normal, shear; };

}  // namespace blocks::dynamics
