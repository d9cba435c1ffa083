// Dimensions of quantities, and the units of the user. A deck may use any consistent
// units, so a figure shows [L T^-1] unless the user names them.
#pragma once

#include <optional>
#include <string>

#include "quantities/dimension.hpp"
#include "quantities/units.hpp"

namespace blocks::post {

using quantities::Dimension;

/// Reads "m,kg,s". Throws std::runtime_error unless there are three names.
Units parse_units(const std::string& text);

/// Returns "m,kg,s".
std::string names_of(const Units& units);

/// The factors by which numbers in some units are multiplied to be in others.
struct UnitScale {
  double length = 1.0, mass = 1.0, time = 1.0;

  bool is_one() const { return length == 1.0 && mass == 1.0 && time == 1.0; }
  /// Returns the factor of a quantity of that dimension.
  double of(const Dimension& dimension) const;
  /// Returns the factors from one set of units to another. Units with the same name
  /// have the factor 1. Throws std::runtime_error that lists the known units if a
  /// factor is not known.
  static UnitScale between(const Units& from, const Units& to);
};

/// Returns the unit: "m/s", "Pa", "N/m"; "cm ms⁻²" in other units; "L T⁻¹" without
/// units; empty for a dimensionless quantity.
std::string unit_text(const Dimension& dimension, const std::optional<Units>& units);

/// Returns "t = 0.3 s", or "t = 0.3 s, nearest to 0.32 s" if the time asked for is
/// another one when both are written with four digits.
std::string time_text(double time, std::optional<double> requested,
                      const std::optional<Units>& units);

}  // namespace blocks::post
