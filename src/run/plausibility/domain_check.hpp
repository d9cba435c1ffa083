// Rules of plausibility about blocks and the domain (docs/plausibility.md).
#pragma once

#include <vector>

#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

/// Returns a doubt for each of XLIMITS and YLIMITS about the new free blocks that have
/// a corner outside its limits: the first step after them fixes these blocks. A block
/// outside both is named once, with XLIMITS.
std::vector<Doubt> doubt_outside_domain(const Plan& plan);

/// Returns a doubt for each of XLIMITS and YLIMITS about the new free blocks inside the
/// domain that reach to its edge, up to rounding. The least motion takes them out.
std::vector<Doubt> doubt_edge_of_domain(const Plan& plan);

}  // namespace blocks::run
