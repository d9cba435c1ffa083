// Corners that stand on or near another block's side or corner. Private to
// src/exchange.
#pragma once

#include "exchange/soundness.hpp"

namespace blocks::exchange {

/// Fills on_sides and near_corners. A corner is reported once for each other block
/// whose side it stands on; a corner that is the same point as a corner of that block
/// is none of these.
void find_meetings(const std::vector<geometry::Polygon>& outlines, Soundness& result);

}  // namespace blocks::exchange
