// The quantities of the page of `blocks view`, and which of them it computes itself.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "quantities/quantity.hpp"

namespace blocks::post {

/// The quantities that the page shows, in this order. It shows the unbalanced forces
/// only if the results have them.
inline constexpr std::array view_quantities = {"displacement",
                                               "dx",
                                               "dy",
                                               "speed",
                                               "vx",
                                               "vy",
                                               "x",
                                               "y",
                                               "rotation",
                                               "spin",
                                               "fx",
                                               "fy",
                                               "moment",
                                               "s11",
                                               "s22",
                                               "s12",
                                               "p1",
                                               "p2",
                                               "unbalanced",
                                               "local_ratio",
                                               "kinetic_energy",
                                               "overlap",
                                               "contacts"};

/// Returns the names of those that results with or without unbalanced forces have.
inline std::vector<std::string> names_of_quantities(bool unbalanced) {
  std::vector<std::string> names;
  for (const char* name : view_quantities)
    if (unbalanced || !quantities::is_of_equilibrium(name))
      names.emplace_back(name);
  return names;
}

/// Predictions of a quantity from others. The page computes them with the same
/// operations in the same order, so only errors of rounding to six digits must be
/// stored.
struct ViewFormula {
  const char *quantity, *name;
  std::array<const char*, 3> operands;
};
inline constexpr std::array view_formulas = {
    ViewFormula{"x", "moved_x", {"dx", nullptr, nullptr}},
    ViewFormula{"y", "moved_y", {"dy", nullptr, nullptr}},
    ViewFormula{"displacement", "length", {"dx", "dy", nullptr}},
    ViewFormula{"speed", "length", {"vx", "vy", nullptr}},
    ViewFormula{"p1", "principal_1", {"s11", "s22", "s12"}},
    ViewFormula{"p2", "principal_2", {"s11", "s22", "s12"}},
    ViewFormula{"kinetic_energy", "energy", {"vx", "vy", "spin"}}};

}  // namespace blocks::post
