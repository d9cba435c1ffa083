// Audits the force of water on blocks against exact areas below the water table
// (docs/audit.md).
#pragma once

#include "audit/audit.hpp"

namespace blocks::audit {

/// Returns the free block whose force of water differs most from the exact one. That is
/// the sum over the straight parts of the table of the area of the block below it times
/// minus the gradient of the pressure, found by clipping the outline in rational
/// numbers. Blocks with pressures of JWATER are left out; the block is -1 if none is
/// left.
WaterError worst_water(const Moment& moment);

}  // namespace blocks::audit
