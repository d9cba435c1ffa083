// Renumbers blocks internally for memory locality, if the numbers of a large model jump
// about. Output is unaffected. Independent of the time loop.
#pragma once

#include <cstddef>
#include <vector>

#include "model/model.hpp"

namespace blocks {

/// Smallest number of blocks for which renumbering is considered. Smaller models stay
/// in the cache in any order.
inline constexpr int min_worth_numbering = 4000;

/// Returns all block numbers, (n) from 0, ordered by strips and along each strip by
/// centroid. The strips run across the longer side of the model and are 1.5 typical
/// block sizes wide. Blocks with equal positions keep the order of their numbers.
std::vector<int> strip_order(const Blocks& blocks);

/// Returns strip_order if it pays, otherwise an empty order. It pays from `min`
/// blocks on, if the path from centroid to centroid by number is more than 16 times as
/// long as by strips. The ratio is 1 to 2 for numbering by rows or columns. It exceeds
/// 16 if about a thousand blocks side by side are numbered at random.
std::vector<int> order_if_worthwhile(const Blocks& blocks,
                                     int min = min_worth_numbering);

/// Returns the deck's number of block b of an order (Model::order). An empty order is
/// that of the numbers.
inline int number_in_deck(const std::vector<int>& order, int b) {
  return order.empty() ? b : order[static_cast<std::size_t>(b)];
}

/// Old and new numbers of the same items.
struct NewNumbers {
  std::vector<int> old_of;  ///< by new number
  std::vector<int> new_of;  ///< by old number

  int size() const { return static_cast<int>(old_of.size()); }
};

/// Gives the blocks of a model other numbers; the order of the corners within a block
/// is kept. Guarantee: reverse() restores the old model bit by bit.
class Numbering {
 public:
  Numbering() = default;
  /// order: the old numbers of all blocks, in the new order.
  Numbering(const Blocks& old, const std::vector<int>& order);
  /// The same from blocks that already have their new numbers.
  static Numbering of_renumbered(const Blocks& now, const std::vector<int>& order);
  Numbering reverse() const;

  const NewNumbers& blocks() const { return blocks_; }
  const NewNumbers& corners() const { return corners_; }

  /// Renumbers what a step reads and writes: blocks, contacts with blocks and planes,
  /// loads, drives and servos. Lists are sorted by the new numbers, except for loads.
  /// Columns of blocks keep their memory. The rest of the model stays as it is.
  void renumber(Model& model) const;

 private:
  void renumber(Blocks& blocks) const;
  void renumber_contacts(Model& model) const;

  NewNumbers blocks_, corners_;
};

}  // namespace blocks
