// The parts of the Python module `blocks._blocks`.
#pragma once

#include <pybind11/pybind11.h>

namespace blocks::python {

namespace py = pybind11;

void bind_cards(py::module_& module);          ///< the table of cards
void bind_displacements(py::module_& module);  ///< of blocks that have split
void bind_predicates(py::module_& module);     ///< exact predicates on arrays
void bind_run(py::module_& module);            ///< run and check a deck
void bind_simulation(py::module_& module);     ///< a model, step by step
void bind_study(py::module_& module);          ///< the study of contact detection
void bind_values(py::module_& module);         ///< values of many blocks

}  // namespace blocks::python
