// The energy that the springs of a contact store, by its law (docs/laws.md#energy).
#pragma once

#include "dynamics/contacts/law_table.hpp"
#include "dynamics/kernels/joint_contact.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Energies of the springs of a contact, [F L].
struct SpringEnergy {
  double normal = 0.0, shear = 0.0;
  double both() const { return normal + shear; }
};

/// Returns the state of a contact of the list, as its law sees it.
ContactState<double> state_of(const Contact& contact, const LawState& state);

/// Refers to the settings and the table.
class SpringEnergies {
 public:
  SpringEnergies(const Settings& settings, const LawTable& laws);
  /// Returns the energies of a contact. law: number in the table. Law 0, and contacts
  /// that have no stiffness yet, have that of STIFF.
  SpringEnergy of(int law, ContactState<double> state) const;
  /// Returns the energies of a contact of the list. state: null without laws.
  SpringEnergy of(const Contact& contact, const LawState* state) const;

 private:
  const Settings& settings_;
  const LawTable& laws_;
};

}  // namespace blocks::dynamics
