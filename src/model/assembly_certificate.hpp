// Proof, before the first step, that no two blocks occupy the same place (the blocks of
// one layer are certified when it is cut). Knows nothing of cards.
#pragma once

#include <string>
#include <vector>

#include "geometry/overlap.hpp"
#include "model/blocks.hpp"

namespace blocks {

/// Corners of turned blocks are rounded decimals: an overlap of up to this part of the
/// smaller block is no fault of a deck.
constexpr double rounding_overlap = 1e-9;

struct AssemblyCertificate {
  int blocks = 0;                                ///< blocks looked at
  std::vector<geometry::BlockOverlap> overlaps;  ///< beyond rounding, in order
  int rounding_pairs = 0;         ///< pairs that overlap by rounding only
  double largest_rounding = 0.0;  ///< their largest area over the smaller block's
  bool holds() const { return overlaps.empty(); }
};

/// Exact decision for every pair of which at least one block is first_new or later,
/// n log n. Law: the order of the blocks changes nothing but their numbers.
AssemblyCertificate certify_assembly(const Blocks& blocks, int first_new = 0);

/// The verdict in one line: "no two of 120 blocks overlap".
std::string verdict(const AssemblyCertificate& certificate);

}  // namespace blocks
