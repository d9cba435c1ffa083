// The laws of joints by their kind (docs/laws.md). A new law is a bit, a function
// apply_... and its energy, and a line in each function below.
#pragma once

#include <type_traits>

#include "dynamics/kernels/barton_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/kernels/walton_law.hpp"

namespace blocks::dynamics {

/// Kinds of laws, one bit for each LawKind. 0: none, STIFF and FRICTN.
using LawBits = unsigned;
inline constexpr LawBits no_law = 0, coulomb_bit = 1, walton_bit = 2, barton_bit = 4,
                         all_laws = 7;

/// Returns whether these are one kind.
[[gnu::always_inline]] constexpr bool is_one_law(LawBits laws) {
  return laws != 0 && (laws & (laws - 1)) == 0;
}

/// Advances `state` by one step with the law of a kind, and computes `force`, [F].
/// may_start: false if motion.starting is known to be 0.
template <LawBits law, bool may_start, class Number>
[[gnu::always_inline]] inline void apply_law(const LawValues<Number>& values, double dt,
                                             const ContactMotion<Number>& motion,
                                             ContactState<Number>& state,
                                             ContactForce<Number>& force) {
  static_assert(is_one_law(law));
  if constexpr (law == coulomb_bit)
    apply_coulomb<may_start>(values, dt, motion, state, force);
  else if constexpr (law == walton_bit)
    apply_walton<may_start>(values, dt, motion, state, force);
  else if constexpr (law == barton_bit)
    apply_barton<may_start>(values, dt, motion, state, force);
}

/// Returns the elastic energy of the normal spring, [F L] >= 0.
template <LawBits law, class Number>
[[gnu::always_inline]] inline Number normal_energy(const LawValues<Number>& values,
                                                   const ContactState<Number>& state) {
  static_assert(is_one_law(law));
  if constexpr (law == coulomb_bit)
    return coulomb_energy(state);
  else if constexpr (law == walton_bit)
    return walton_energy(values, state);
  else if constexpr (law == barton_bit)
    return barton_energy(values, state);
}

/// Calls act(std::integral_constant<LawBits, law>()) for each of these kinds.
template <class Act>
[[gnu::always_inline]] inline void each_law(LawBits laws, const Act& act) {
  if ((laws & coulomb_bit) != 0)
    act(std::integral_constant<LawBits, coulomb_bit>());
  if ((laws & walton_bit) != 0)
    act(std::integral_constant<LawBits, walton_bit>());
  if ((laws & barton_bit) != 0)
    act(std::integral_constant<LawBits, barton_bit>());
}

}  // namespace blocks::dynamics
