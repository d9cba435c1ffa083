// Rules of plausibility about numbers that do not fit together: springs too soft or too
// stiff and blocks too soft for the weight on them, a contact tolerance too large for
// the blocks, and a block much smaller than the others (docs/plausibility.md).
#pragma once

#include <vector>

#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

/// Estimates the overlap at rest under gravity: the weight W of the heaviest column of
/// free blocks on its lowest block, divided by the normal stiffness Kn. Returns a doubt
/// if it is more than a twentieth of the least width of that block.
std::vector<Doubt> doubt_stiffness(const Plan& plan);

/// Returns a doubt if this overlap is less than the slack of a side as long as the
/// block is wide, unless other loads or bonds act, too. Then rounding and the age of
/// kept decisions count (docs/kept-decisions.md).
std::vector<Doubt> doubt_overlap(const Plan& plan);

/// Estimates the compression at rest of deformable blocks: the weight of the heaviest
/// column per width, divided by E of its lowest block. Returns a doubt if it is more
/// than a twentieth.
std::vector<Doubt> doubt_modulus(const Plan& plan);

/// Returns a doubt if the contact tolerance is more than the least width of the
/// narrowest free block. Blocks of doubt_tiny_block() do not count.
std::vector<Doubt> doubt_tolerance(const Plan& plan);

/// Returns a doubt if the program chooses the time step and nothing damps. The largest
/// stable step is too coarse for impacts without damping.
std::vector<Doubt> doubt_step(const Plan& plan);

/// Returns a doubt if the area of the smallest free block is less than a millionth of
/// the median. Such a block is mostly a sliver of a cut, and its mass sets the time
/// step of all.
std::vector<Doubt> doubt_tiny_block(const Plan& plan);

}  // namespace blocks::run
