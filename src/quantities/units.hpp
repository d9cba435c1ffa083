// The units of length, mass and time that values can be converted from and to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/settings.hpp"

namespace blocks::quantities {

/// The units of one dimension.
struct KnownUnits {
  struct Unit {
    const char* name;
    double size;  ///< in m, kg or s, > 0
  };
  const char* dimension;  ///< "length", "mass" or "time"
  std::vector<Unit> units;

  /// Returns the size of the unit with this name, case-sensitive, if it is known.
  std::optional<double> size_of(const std::string& name) const;
  /// Lists the names: "m, mm, ...".
  std::string names() const;
};

const KnownUnits& known_lengths();
const KnownUnits& known_masses();
const KnownUnits& known_times();

}  // namespace blocks::quantities
