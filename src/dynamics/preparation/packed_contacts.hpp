// The contacts that a block of packed rock may have, for time steps that are stable
// (docs/theory.md#time-step).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns how many contacts each free block may have, (n); 0 for other blocks. Each
/// corner of the block counts twice, for the blocks on both sides of it, and up to two
/// corners of other blocks within `tolerance` [L] of it count, too. So does each corner
/// of another block within it of a side. The number is weighted: it is that of a
/// rectangle whose corners have all contacts, so that springs of the same stiffness
/// give both the same highest frequency.
Eigen::VectorXd packed_contacts(const Blocks& blocks, double tolerance);

/// Returns how many corners of two blocks are within `tolerance` [L] of the outline of
/// the other one.
int touching_corners(const Blocks& blocks, int a, int b, double tolerance);

/// Returns by how much the stiffness of STIFF has to be multiplied in (4), (n), so that
/// a step that is safe for 8 contacts is safe for those of packed_contacts(). It is at
/// least 1.
Eigen::VectorXd contact_shares(const Model& model);

}  // namespace blocks::dynamics
