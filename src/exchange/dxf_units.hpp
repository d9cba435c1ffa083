// The units of length of DXF drawings ($INSUNITS), with the names of UNITS. Private to
// src/exchange.
#pragma once

#include <array>
#include <string>

namespace blocks::exchange {

/// The names by code; empty: none, or not a unit of UNITS.
inline constexpr std::array dxf_units{"", "in", "ft", "", "mm", "cm", "m", "km"};

/// Returns the name of a code, or an empty text.
inline std::string dxf_unit(int code) {
  return code >= 0 && code < static_cast<int>(dxf_units.size())
             ? dxf_units[static_cast<std::size_t>(code)]
             : "";
}

/// Returns the code of a unit, or 0.
inline int dxf_code_of(const std::string& unit) {
  for (std::size_t code = 1; code < dxf_units.size(); ++code)
    if (!unit.empty() && unit == dxf_units[code])
      return static_cast<int>(code);
  return 0;
}

}  // namespace blocks::exchange
