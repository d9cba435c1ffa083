// Renumbers blocks internally for memory locality, if the numbers of a large model jump
// about. Output is unaffected. Independent of the time loop.
#pragma once

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

/// Old and new numbers of the same items.
struct NewNumbers {
  std::vector<int> old_of;  ///< by new number
  std::vector<int> new_of;  ///< by old number

  int size() const { return static_cast<int>(old_of.size()); }
};

/// Maps a model to one with the same blocks in another order; the order of the corners
/// within a block is kept. Guarantee: reverse() restores the old model bit by bit.
class Numbering {
 public:
  Numbering() = default;
  /// order: the old numbers of all blocks, in the new order.
  Numbering(const Blocks& old, const std::vector<int>& order);
  Numbering reverse() const;

  const NewNumbers& blocks() const { return blocks_; }
  const NewNumbers& corners() const { return corners_; }

  void renumber(const Blocks& from, Blocks& to) const;
  /// Renumbers corners and edges and sorts the list by sort_key. blocks: the renumbered
  /// blocks.
  void renumber(const std::vector<Contact>& from, const std::vector<LawState>& states,
                const Blocks& blocks, std::vector<Contact>& to,
                std::vector<LawState>& states_to) const;
  /// Returns the contacts with planes with new numbers of corners, in their order.
  std::vector<PlaneContact> renumbered(std::vector<PlaneContact> list) const;
  /// Returns the loads with new block numbers; their order is unchanged.
  Loads renumbered(Loads loads) const;
  /// Returns the drives with new block numbers, in ascending order.
  std::vector<Drive> renumbered(std::vector<Drive> drives) const;
  /// Returns the servos with new block numbers, in ascending order.
  std::vector<Servo> renumbered(std::vector<Servo> servos) const;

 private:
  NewNumbers blocks_, corners_;
};

}  // namespace blocks
