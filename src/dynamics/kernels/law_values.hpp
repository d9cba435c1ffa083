// The values of a law of joints that its function needs, in one list
// (docs/laws.md). A Number is a number of one law, that of each lane of a vector, or
// the column of a table of laws.
#pragma once

namespace blocks::dynamics {

/// The list. Members of JointLaw have the same names; the others follow from them
/// (law_table.cpp).
#define BLOCKS_LAW_VALUES(VALUE)                                                       \
  /* Mohr and Coulomb: coefficient, [F/L^2], [F/L^2]; before and after failure */      \
  VALUE(friction)                                                                      \
  VALUE(cohesion)                                                                      \
  VALUE(tension)                                                                       \
  VALUE(residual_friction)                                                             \
  VALUE(residual_cohesion)                                                             \
  VALUE(residual_tension)                                                              \
  /* tangent of the dilation angle, [L] */                                             \
  VALUE(dilation)                                                                      \
  VALUE(dilation_limit)                                                                \
  /* Walton: K2 / K1 = 1 / e^2 */                                                      \
  VALUE(unloading_ratio)                                                               \
  /* Barton: JRC, JCS [F/L^2], phi_r in radians (at most 70 degrees), upeak [L] */     \
  VALUE(roughness)                                                                     \
  VALUE(wall_strength)                                                                 \
  VALUE(residual_angle)                                                                \
  VALUE(peak_slip)                                                                     \
  /* Bandis: vm [L]; vm (1 - sqrt(kni / knmax)) [L], where the tangent is knmax */     \
  VALUE(largest_closure)                                                               \
  VALUE(linear_from)                                                                   \
  /* Barton: JointLaw::strength_share */                                               \
  VALUE(strength_share)                                                                \
  /* [F/L^3] kn or kni, and ks, per length of the contact; 0: STIFF */                 \
  VALUE(normal_stiffness)                                                              \
  VALUE(shear_stiffness)

template <class Number> struct LawValues {
#define BLOCKS_MEMBER(member) Number member;
  BLOCKS_LAW_VALUES(BLOCKS_MEMBER)
#undef BLOCKS_MEMBER
};

/// Calls act(one.member, other.member, ...) for each value.
template <class Act, class... Values>
[[gnu::always_inline]] inline void each_value(const Act& act, Values&&... values) {
#define BLOCKS_ACT(member) act(values.member...);
  BLOCKS_LAW_VALUES(BLOCKS_ACT)
#undef BLOCKS_ACT
}

}  // namespace blocks::dynamics
