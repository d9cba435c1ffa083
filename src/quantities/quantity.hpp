// The quantities of a block: those of Table F.1 of the report, and others.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "quantities/dimension.hpp"
#include "quantities/state.hpp"

namespace blocks::quantities {

/// The description of a quantity of a block.
struct QuantityKind {
  std::string name;         ///< "vx"
  std::string report_name;  ///< "VELX" of Table F.1, or empty
  std::string label;        ///< "velocity x"
  Dimension dimension;
  bool is_signed = false;
  bool additive = false;  ///< the sum over blocks is the value of the model
  /// Returns the value of block b, from 0. `first` has the positions of the first
  /// frame; blocks made after it have not moved.
  std::function<double(const BlockStates& now, const Positions& first, int b)> value;
};

/// Returns the largest (sign 1) or the smallest (-1) principal value of a symmetric
/// tensor with the rows 11, 12, 21, 22.
double principal(const Eigen::Vector4d& tensor, double sign);

/// All of them, the most used first.
const std::vector<QuantityKind>& quantity_kinds();

/// Finds a quantity by name or report name, in upper or lower case; nullptr if there is
/// none. "ke" is the kinetic energy.
const QuantityKind* find_quantity(const std::string& name);

/// Lists the names: "speed, displacement, ...".
std::string quantity_names();

/// The quantity of the model that tells how far it is from equilibrium.
inline constexpr const char* ratio_name = "unbalanced_ratio";

/// The largest local ratio of a block: what SOLVE tests beside the ratio.
inline constexpr const char* largest_local_name = "unbalanced:local";

/// Whether a quantity depends on the forces of water.
bool is_of_water(const std::string& name);

/// True for the unbalanced force of a block, its local ratio, the largest of these and
/// the ratio of the model. Results have them only if the deck asks for equilibrium
/// (docs/rest.md#the-ratio). Takes a name.
bool is_of_equilibrium(const std::string& name);
/// True for the local ratio of a block and for the largest one.
bool is_of_local_ratio(const std::string& name);

/// True for the stresses that the material law gives, and the applied ones.
bool is_stress(const QuantityKind& kind);

}  // namespace blocks::quantities
