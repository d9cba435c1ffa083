// Rules of plausibility about cards and what they do together (docs/plausibility.md).
#pragma once

#include <vector>

#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

/// A friction coefficient that looks like an angle.
std::vector<Doubt> doubt_friction(const Plan& plan);

/// Blocks that the outline of a REMOVE or FREE card crosses. At the end of a card, the
/// blocks that it has removed are gone.
std::vector<Doubt> doubt_outline(const Plan& plan);

/// The weight of the water of a WATER card, which is not that of water.
std::vector<Doubt> doubt_water(const Plan& plan);

/// JOINT cards whose peak strength acts nowhere, because no BOND card names their id.
/// A restart is not tested: its checkpoint may have bonds.
std::vector<Doubt> doubt_strength(const Plan& plan);

/// GRAVITY and WATER cards whose ramp lasts longer than the motions that follow. A
/// SOLVE card takes unknown time, so a ramp with a SOLVE is not tested.
std::vector<Doubt> doubt_ramp(const Plan& plan);

/// A deck that makes no step.
std::vector<Doubt> doubt_motion(const Plan& plan);

/// MSCALE cards that no SOLVE follows.
std::vector<Doubt> doubt_scaling(const Plan& plan);

}  // namespace blocks::run
