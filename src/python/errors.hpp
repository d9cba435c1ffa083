// The exceptions of the Python package, raised from C++ (blocks/errors.py). Call all
// functions with the lock of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "blocks/simulation.hpp"

namespace blocks::python {

namespace py = pybind11;

/// The messages of a run or a check.
struct Messages {
  std::string printed;  ///< those about the deck, as on the command line
  std::vector<DeckMessage> of_deck;
  std::vector<std::string> of_run;  ///< warnings

  bool has_errors() const;
};

/// Raises an exception of blocks.errors with this message.
[[noreturn]] void raise(const char* name, const std::string& message);
/// Raises DeckError or FileError with the diagnostics about a deck.
[[noreturn]] void raise(const char* name, const Messages& messages);
/// Gives the warnings to the module `warnings` of Python.
void warn(const Messages& messages);
/// Translates the exceptions of the library, and registers Diagnostic.
void bind_errors(py::module_& module);

}  // namespace blocks::python
