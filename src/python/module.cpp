// The Python module blocks._blocks (docs/python.md).
#include <pybind11/pybind11.h>

#include "bindings.hpp"
#include "errors.hpp"

PYBIND11_MODULE(_blocks, module) {
  module.doc() = "The compiled part of the package `blocks`.";
  module.attr("__version__") = BLOCKS_VERSION;
  pybind11::options options;
  options.disable_function_signatures();  // docstrings have their own
  blocks::python::bind_errors(module);
  blocks::python::bind_cards(module);
  blocks::python::bind_displacements(module);
  blocks::python::bind_drawing(module);
  blocks::python::bind_run(module);
  blocks::python::bind_simulation(module);
  blocks::python::bind_predicates(module);
  blocks::python::bind_study(module);
  blocks::python::bind_values(module);
}
