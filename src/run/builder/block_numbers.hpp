// The blocks that numbers on cards mean. Faulty cards hide blocks that count as blocks
// of the deck, and blocks that split before a card acts move the numbers of later ones.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "deck/commands.hpp"

namespace blocks::run {

class BlockNumbers {
 public:
  /// `unread`: the cards that could not be read. `blocks`: those that no card of this
  /// deck makes.
  BlockNumbers(std::vector<deck::UnreadCard> unread, int blocks)
      : unread_(std::move(unread)), certain_(blocks) {}

  /// Registers that there are so many blocks above this line. Counts those of CREATE
  /// cards above it that were not read.
  void count(int line, int blocks);
  /// Registers that the card has failed to make its blocks behind so many others.
  void add_failed(const deck::Command& command, int blocks);
  /// Registers that blocks may split from now on when the deck runs, so that the
  /// numbers of later blocks are not known before.
  void may_split(int blocks);
  /// Registers that the run has come here, so that no number is unknown.
  void forget_splits() { before_splits_.reset(); }

  /// How many blocks that cards above this line should make are missing at most.
  long max_missing(int line) const;
  /// Whether cards have failed to make blocks.
  bool some_failed() const { return failed_ > 0; }
  /// The number of the last of so many blocks, if no other card than CREATE has failed.
  long last(int blocks) const { return blocks + missing_; }
  /// Whether the last blocks, from this number on, may be pieces when the deck runs,
  /// and not the blocks that cards make.
  bool is_unsure(long number, int blocks) const {
    return before_splits_ && number > *before_splits_ && number <= last(blocks);
  }
  /// Returns the number of a block on the cards, from 1.
  long number_of(int block) const;
  /// Returns the index of the block with this number, from 1 to the last one. Returns
  /// -1 if the block is missing, or if missing blocks hide which one it is.
  int index_of(long number) const;

 private:
  /// Blocks that CREATE cards should have made before the block with this index.
  struct Gap {
    int before;
    long count;
  };
  void add_gap(int before, long count);

  std::vector<deck::UnreadCard> unread_;
  std::size_t unread_counted_ = 0;  ///< unread cards whose blocks are counted
  int certain_;                     ///< blocks whose numbers are certain
  std::vector<Gap> gaps_;           ///< by ascending index
  long missing_ = 0;                ///< in all gaps
  long failed_ = 0;  ///< the most blocks that cards with errors should make
  /// The number of blocks before the first motion in which blocks may split; empty if
  /// there is none, or if steps are made.
  std::optional<long> before_splits_;
};

}  // namespace blocks::run
