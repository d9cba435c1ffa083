// Certificate that no two blocks overlap before a motion, and a record of how they
// meet. Blocks of one layer are certified when the layer is cut. Independent of cards.
#pragma once

#include <memory>
#include <vector>

#include "geometry/joints.hpp"
#include "geometry/overlap.hpp"
#include "model/blocks.hpp"

namespace blocks {

/// Listing and summary name at most this many pairs of each kind, beside the total
/// count.
constexpr std::size_t max_pairs_named = 100;

/// The result of certify_assembly. Overlapping blocks that have both moved are in
/// contact: the motion made them overlap, not the deck.
struct AssemblyCertificate {
  int blocks = 0;   ///< number of blocks, including the removed ones
  int removed = 0;  ///< number of removed blocks, which are not examined
  int moved = 0;  ///< number of blocks, the first ones, that existed during a time step
  /// Overlaps larger than rounding explains, in order.
  std::vector<geometry::BlockOverlap> overlaps;
  std::vector<geometry::BlockOverlap> roundings;  ///< explained by rounding, in order
  std::vector<geometry::BlockOverlap> contacts;   ///< between moved blocks, in order
  /// The largest area in `roundings`, as a fraction of the smaller block's area.
  double largest_rounding = 0.0;

  /// Slits are in this order: gaps, then slits made by rounding, both the widest first.
  /// Joints between moved blocks are left out.
  geometry::Joints joints;
  std::size_t t_junctions = 0;  ///< their number, also if the list is not kept
  /// Number of slits made by rounding; they are at the end of the list.
  std::size_t rounding_slits = 0;
  double ulp = 0.0;  ///< [L] spacing of doubles at the largest coordinate

  bool holds() const { return overlaps.empty(); }
  /// The number of slits wider than rounding explains.
  std::size_t gaps() const { return joints.slits.size() - rounding_slits; }
};

/// One certificate shared by all outputs; null if there are no blocks.
using SharedCertificate = std::shared_ptr<const AssemblyCertificate>;

/// Decides exactly for every pair of blocks, in O(n log n) time. moved: see
/// AssemblyCertificate::moved. before: the last certificate of these blocks; its
/// overlaps remain overlaps as long as they exist. Guarantee: the order of the blocks
/// affects only their numbers in the result. progress: called during the work; may
/// throw to stop it.
AssemblyCertificate certify_assembly(const Blocks& blocks, int moved = 0,
                                     const AssemblyCertificate& before = {},
                                     const geometry::ProgressFunction& progress = {});

}  // namespace blocks
