// The outlines that the cards of a deck describe, before any block is made.
#pragma once

#include <vector>

#include "deck/commands.hpp"
#include "geometry/shared_corners.hpp"

namespace blocks::run {

/// Returns the outline of a CREATE card with its copies.
geometry::DeckOutline outline_of(const deck::Create& card);

/// Returns the corners shared by the LAYER and CREATE cards of each section of the
/// deck. A section ends at a MOTION, CYCLE or SOLVE card or at the end of the deck.
/// Blocks of earlier sections have moved, so they share no corners.
std::vector<geometry::SharedCorners>
shared_corners(const std::vector<deck::Command>& cards);

}  // namespace blocks::run
