// Names that a deck gives to units and materials.
#pragma once

#include <pybind11/pybind11.h>

#include <map>

#include "model/settings.hpp"

namespace blocks::python {

/// Returns the names of length, mass and time; None if the deck names no units.
inline pybind11::object unit_names(const Units& units) {
  if (!units.known())
    return pybind11::none();
  return pybind11::make_tuple(units.length, units.mass, units.time);
}

/// Returns the names of the materials that have one, by number.
inline pybind11::dict material_names(const std::map<int, Material>& materials) {
  pybind11::dict names;
  for (const auto& [number, material] : materials)
    if (!material.name.empty())
      names[pybind11::int_(number)] = material.name;
  return names;
}

}  // namespace blocks::python
