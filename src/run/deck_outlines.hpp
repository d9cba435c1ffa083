// The outlines that the cards of a deck describe, before any is made.
#pragma once

#include <vector>

#include "deck/commands.hpp"
#include "geometry/shared_corners.hpp"

namespace blocks::run {

/// One for each stretch of the deck that ends with MOTION, CYCLE or the deck: the
/// corners that its LAYER and CREATE cards share. Earlier blocks have moved by then and
/// share none.
std::vector<geometry::SharedCorners>
shared_corners(const std::vector<deck::Command>& cards);

}  // namespace blocks::run
