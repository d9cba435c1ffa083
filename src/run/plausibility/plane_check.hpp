// Blocks behind symmetry planes (docs/plausibility.md, docs/departures.md).
#pragma once

#include <vector>

#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

/// Returns whether all corners that are present lie behind the plane, on the right when
/// looking from point 1 to point 2.
bool are_all_behind(const Blocks& blocks, const Plane& plane);

/// New free blocks that are wholly or partly behind a plane, unless all blocks are.
/// Depths up to rounding do not count.
std::vector<Doubt> doubt_behind_plane(const Plan& plan);

}  // namespace blocks::run
