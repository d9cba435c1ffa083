// A deck around imported blocks, to be filled in by the user.
#pragma once

#include <string>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// A deck that reads `mesh` (READ9) and passes `blocks check`: limits a tenth wider
/// than the blocks, boxes and tolerance from their size, one MATERIAL for each number
/// in use, FIX for fixed blocks. Stiffness, densities and gravity are assumed values of
/// rock in m, kg, s, and the deck says so. Throws std::range_error: the blocks are so
/// large or small that their areas are no numbers to calculate with.
std::string write_deck_skeleton(const std::vector<Outline>& outlines,
                                const std::string& mesh);

}  // namespace blocks::exchange
