// How far single blocks are from equilibrium (docs/rest.md#the-local-ratio).
#pragma once

#include <limits>

#include "model/model.hpp"

namespace blocks {

/// Forces on a free block that are together smaller than this share of the largest sum
/// on any free block are rounding: a block that touches others without a load. A larger
/// share would hide small blocks that fall beside blocks under high stress.
inline constexpr double negligible_forces = 1e-9;

/// Sets ratios[b] to the local ratio of each block, (n): its unbalanced force
/// (equilibrium.hpp) over the sum of the sizes of all forces on it. These are the
/// forces of contacts with their dashpots, of symmetry planes and of loads, and the
/// weight. It is 0 in equilibrium and 1 in free fall. Returns 0 for blocks that are not
/// free and for those with `negligible_forces`. Forces of contacts must be known.
void local_ratios(const Model& model, Eigen::VectorXd& ratios);

/// How far a model is from equilibrium, as a whole and in its worst block.
struct Balance {
  double ratio = std::numeric_limits<double>::quiet_NaN();  ///< unbalanced_ratio()
  double local = std::numeric_limits<double>::quiet_NaN();  ///< largest local ratio
  int block = -1;  ///< the first block that has it; -1: all are in equilibrium
};
Balance balance_of(const Model& model);

}  // namespace blocks
