// Proof, before time passes, that no two blocks occupy the same place, and how they
// meet (the blocks of one layer are certified when it is cut). Knows nothing of cards.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/joints.hpp"
#include "geometry/overlap.hpp"
#include "model/blocks.hpp"

namespace blocks {

/// Listing and summary name so many pairs of each kind; the count stands beside them.
constexpr std::size_t most_pairs_named = 100;

/// Pairs of blocks that have moved are contacts where they overlap: the deck did not
/// make them so, the motion did.
struct AssemblyCertificate {
  int blocks = 0;  ///< blocks looked at
  int moved = 0;  ///< the first of them, which time has passed for since they were made
  std::vector<geometry::BlockOverlap> overlaps;   ///< beyond rounding, in order
  std::vector<geometry::BlockOverlap> roundings;  ///< by rounding only, in order
  std::vector<geometry::BlockOverlap> contacts;   ///< of moved blocks, in order
  double largest_rounding = 0.0;  ///< their largest area over the smaller block's

  /// Slits: gaps, then those of rounding, the widest first; T-junctions. None between
  /// moved blocks.
  geometry::Joints joints;
  std::size_t t_junctions = 0;     ///< how many, also where they are not kept
  std::size_t rounding_slits = 0;  ///< the last of the slits, made by rounding
  double ulp = 0.0;  ///< [L] between neighbouring doubles at the largest coordinate

  bool holds() const { return overlaps.empty(); }
  /// Slits wider than rounding makes them.
  std::size_t gaps() const { return joints.slits.size() - rounding_slits; }
};

/// One certificate for all who tell of it; nothing: there are no blocks.
using SharedCertificate = std::shared_ptr<const AssemblyCertificate>;

/// Exact decision for every pair, n log n. moved: as in the certificate; before: the
/// last certificate of these blocks, whose overlaps stay overlaps as long as they last.
/// Law: the order of the blocks changes nothing but their numbers.
AssemblyCertificate certify_assembly(const Blocks& blocks, int moved = 0,
                                     const AssemblyCertificate& before = {});

/// The verdict in one line: "no two of 120 blocks overlap".
std::string verdict(const AssemblyCertificate& certificate);

/// Gaps, slits of rounding and T-junctions in one line, the widest gap with its place:
/// "1 gap, 0.0004 between blocks 1 and 4 at (-3, 0); 2 T-junctions".
std::string joints_line(const AssemblyCertificate& certificate);

/// The lines of the listing: verdict, joints, and the first `most_pairs_named`
/// overlaps, roundings and gaps, the number of the others beside them.
std::string full_text(const AssemblyCertificate& certificate);

}  // namespace blocks
