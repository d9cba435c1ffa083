// Checks the laws of joints, the states of contacts and the driven blocks of a
// checkpoint.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects laws that the cards JOINT, WALTON, BARTON and JPAIR can define. Throws
/// hdf5::Failure otherwise.
void expect_laws(const Settings& settings);

/// Expects one state for each contact, or none if there are no laws. Throws
/// hdf5::Failure otherwise.
void expect_joint_states(const Model& model);

/// Expects driven blocks in ascending order, all fixed by the user, with the velocity
/// of their drive. Throws hdf5::Failure otherwise.
void expect_drives(const Model& model);

}  // namespace blocks::output
