// Proof, before the first step, that no two blocks occupy the same place (the blocks of
// one layer are certified when it is cut). Knows nothing of cards.
#pragma once

#include <string>
#include <vector>

#include "geometry/overlap.hpp"
#include "model/blocks.hpp"

namespace blocks {

/// Corners are rounded, to doubles and before that to the decimals of a deck: neighbours
/// may overlap along their whole outline by this many units in the last place of their
/// largest coordinate, and by this part of the smaller block's size (twelve digits),
/// without a fault of the deck.
constexpr double rounding_units = 4.0, rounding_part = 1e-11;

struct AssemblyCertificate {
  int blocks = 0;                                 ///< blocks looked at
  std::vector<geometry::BlockOverlap> overlaps;   ///< beyond rounding, in order
  std::vector<geometry::BlockOverlap> roundings;  ///< by rounding only, in order
  double largest_rounding = 0.0;  ///< their largest area over the smaller block's
  bool holds() const { return overlaps.empty(); }
};

/// Exact decision for every pair of which at least one block is first_new or later,
/// n log n. Law: the order of the blocks changes nothing but their numbers.
AssemblyCertificate certify_assembly(const Blocks& blocks, int first_new = 0);

/// The verdict in one line: "no two of 120 blocks overlap".
std::string verdict(const AssemblyCertificate& certificate);

}  // namespace blocks
