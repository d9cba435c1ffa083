// The blocks that faulty CREATE cards did not make. They count as blocks of the deck,
// so that cards name the blocks behind them by the right numbers.
#pragma once

#include <vector>

namespace blocks::run {

class MissingBlocks {
 public:
  /// Records that `count` blocks are missing before the block with the index `before`,
  /// which is not made yet.
  void add(int before, long count);

  long count() const { return count_; }
  /// Returns the number of a block on the cards, from 1.
  long number_of(int block) const;
  /// Returns the index that the block with this number has in the model if there are so
  /// many blocks; -1 if it is missing.
  long index_of(long number) const;

 private:
  struct Gap {
    int before;
    long count;
  };
  std::vector<Gap> gaps_;  ///< by ascending index
  long count_ = 0;
};

}  // namespace blocks::run
