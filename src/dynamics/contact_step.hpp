// The acting contacts of a step in doubles, for the energy account.
#pragma once

#include "dynamics/contact_work.hpp"
#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/spring_energy.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Computes the motion and the forces of contacts once more, with the formulas of the
/// kernels.
class ContactSteps {
 public:
  ContactSteps(const Model& model, const ContactArrays& arrays)
      : blocks_(model.blocks), settings_(model.settings), arrays_(arrays),
        energies_(model.settings, arrays.laws), dt_(model.time_step.dt) {}

  /// Returns the step of the contact in a slot and a lane. To be called after the
  /// forces of the step are known, before the springs advance and blocks move.
  ContactStep at(int slot, int lane) const;
  /// Returns the energy that a contact stores after the springs have advanced, [F L].
  double stored(int slot, int lane) const;

 private:
  ContactForce<double> force_of(int law, const ContactMotion<double>& moves,
                                ContactState<double> state) const;
  ContactMotion<double> motion(int slot, int lane) const;
  ContactState<double> state(const SpringRow* springs, const JointRow* joints, int slot,
                             int lane) const;
  /// Returns the number of the law; 0 for STIFF and FRICTN.
  int law(int slot, int lane) const;
  /// Returns whether contacts of this law have no state.
  bool is_stateless(int law) const { return law == 0 && !arrays_.laws.in_situ(); }

  const Blocks& blocks_;
  const Settings& settings_;
  const ContactArrays& arrays_;
  SpringEnergies energies_;
  double dt_;
};

}  // namespace blocks::dynamics
