// Remembers which card of the deck made a block, so that a message about blocks can
// name the cards to change.
#pragma once

#include <string>
#include <vector>

#include "deck/commands.hpp"

namespace blocks::run {

class BlockMakers {
 public:
  /// `blocks`: the number of blocks that no card of this deck made.
  explicit BlockMakers(int blocks) : before_(blocks) {}

  /// Records that the model has `blocks` blocks after this card.
  void record(const deck::Command& card, int blocks);

  struct Maker {
    int end;  ///< the index after the last block of the card
    std::string name;
    deck::SourceLocation where;

    /// Returns the card as in "CREATE in line 12".
    std::string text() const;
  };
  /// Returns the card that made a block, or null if the block is from a checkpoint.
  const Maker* of(int block) const;

 private:
  int before_;
  std::vector<Maker> makers_;
};

}  // namespace blocks::run
