// Numbers of blocks that lie side by side in the memory where the blocks do, for models
// whose own numbers lead to and fro. Knows no time.
#pragma once

#include <vector>

#include "model/model.hpp"

namespace blocks {

/// Smaller models stay in the cache however they are numbered.
inline constexpr int least_worth_numbering = 4000;

/// The blocks by strips across the longer side of the model, a block and a half wide,
/// and along each strip by their centroids, equal places by number: (n) block numbers
/// from 0.
std::vector<int> strip_order(const Blocks& blocks);

/// The same where it is worth it, else nothing: from `least` blocks on, and where the
/// way from centroid to centroid by number is more than 16 times as long as by strips,
/// as when a thousand blocks side by side are numbered at random; rows and columns come
/// to once or twice.
std::vector<int> better_order(const Blocks& blocks, int least = least_worth_numbering);

/// Old and new numbers of the same things.
struct NewNumbers {
  std::vector<int> old_of;  ///< by new number
  std::vector<int> new_of;  ///< by old number

  int size() const { return static_cast<int>(old_of.size()); }
};

/// From a model to the one of the same blocks in another order; each block keeps its
/// corners in theirs. Laws: what reverse() makes of the new model is the old one, bit
/// by bit.
class Numbering {
 public:
  Numbering() = default;
  /// order: old numbers of all blocks, in the new order.
  Numbering(const Blocks& old, const std::vector<int>& order);
  Numbering reverse() const;

  const NewNumbers& blocks() const { return blocks_; }
  const NewNumbers& corners() const { return corners_; }

  void renumber(const Blocks& from, Blocks& to) const;
  /// Renumbers corners and edges, and sorts the list by sort_key. blocks: the
  /// renumbered ones.
  void renumber(const std::vector<Contact>& from, const Blocks& blocks,
                std::vector<Contact>& to) const;
  void renumber(const PlaneContacts& from, PlaneContacts& to) const;
  /// Loads act in the order they had.
  Loads renumbered(Loads loads) const;

 private:
  NewNumbers blocks_, corners_;
};

}  // namespace blocks
