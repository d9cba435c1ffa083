// Writes a deck for imported blocks that the user completes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Returns the name of a material as a deck can have it: control characters and colons
/// become blanks, and so does " if the name also contains '. A number gets the word
/// "material" before it.
std::string name_in_deck(std::string name);

/// Where the blocks of a deck come from.
struct BlockSource {
  std::string title;      ///< "map.dxf"
  std::string cards;      ///< that make the blocks: "READ9, 'map.mesh.txt'\n"
  std::string unit = {};  ///< of length, if it is known: "mm"
};

/// Returns a deck that makes the blocks and passes `blocks check`. Limits are a
/// tenth wider than the blocks; boxes and tolerance follow from the block size. There
/// is one MATERIAL for each number in use, with its name in the deck, and FIX for fixed
/// blocks.
/// Stiffness, densities and gravity are assumed values of rock in m, kg, s, and the
/// deck says so. Throws std::range_error if the blocks are so large or small that their
/// areas overflow or underflow.
/// material_names: as name_in_deck() returns them.
std::string write_deck_skeleton(const std::vector<Outline>& outlines,
                                const std::map<long, std::string>& material_names,
                                const BlockSource& source);

}  // namespace blocks::exchange
