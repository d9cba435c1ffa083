// Contacts and cracks of a model as structured arrays. Blocks and corners are counted
// from 0; the block of a symmetry plane is -1.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "blocks/simulation.hpp"
#include "model/model.hpp"

namespace blocks::python {

/// Returns a row for each contact, with the state of its law if the model has laws.
pybind11::array contact_table(const std::vector<ContactForce>& contacts,
                              const Model& model);
/// Returns the sum of the contact forces on each block, (n, 2) [F].
pybind11::array contact_forces(const std::vector<ContactForce>& contacts,
                               const Blocks& blocks);

/// Returns the force of water on each block at the present positions, [F], (n, 2).
pybind11::array water_forces(const Model& model);
/// Returns a row for each crack so far.
pybind11::array crack_table(const Model& model);
/// Makes the types of the rows known to NumPy. Call it once.
void register_tables();

}  // namespace blocks::python
