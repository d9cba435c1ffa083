// The parts of the Python module `blocks._blocks`.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "model/blocks.hpp"

namespace blocks::python {

namespace py = pybind11;

/// Returns an answer for each block, (n,).
inline py::array_t<bool> flags_of(const Blocks& blocks, bool (Blocks::*is)(int) const) {
  py::array_t<bool> answers(blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    answers.mutable_data()[b] = (blocks.*is)(b);
  return answers;
}

void bind_cards(py::module_& module);          ///< the table of cards
void bind_displacements(py::module_& module);  ///< of blocks that have split
void bind_drawing(py::module_& module);        ///< colours and faces of figures
void bind_predicates(py::module_& module);     ///< exact predicates on arrays
void bind_run(py::module_& module);            ///< run and check a deck
void bind_simulation(py::module_& module);     ///< a model, step by step
void bind_study(py::module_& module);          ///< the study of contact detection
void bind_values(py::module_& module);         ///< values of many blocks

}  // namespace blocks::python
