// Audits the contacts with symmetry planes (docs/audit.md).
#pragma once

#include <vector>

#include "audit/audit.hpp"

namespace blocks::audit {

/// Returns the corners of free blocks that act on a plane although they are neither
/// behind it nor held by an offset, or do not act although they are behind it. The side
/// on which a corner lies is found in whole numbers.
std::vector<PlaneFault> plane_faults(const Moment& moment);

/// Returns the corner of a free block that is farthest behind a plane. Its depth is
/// rounded, and 0 if there is none.
BehindPlane deepest_behind_plane(const Moment& moment);

}  // namespace blocks::audit
