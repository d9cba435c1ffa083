// Keeps the blocks that a CUT command made. A deck is executed twice, to be checked and
// to be run, and cutting may take long.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace blocks::run {

/// The result of a CUT command.
struct CutOutcome {
  /// Without density; the joints are those of the sides.
  std::vector<NewBlock> blocks;
  CutRecord record;                        ///< without number and first block
  std::vector<JointLengthRecord> lengths;  ///< without the number of the cut
  std::vector<std::string> notes;
};

class CutStore {
 public:
  void put(int line, CutOutcome outcome) {
    made_.insert_or_assign(line, std::move(outcome));
  }
  /// Removes and returns the result of the card in this line of the deck, if there is
  /// one.
  std::optional<CutOutcome> take(int line) {
    auto node = made_.extract(line);
    return node.empty() ? std::nullopt : std::optional(std::move(node.mapped()));
  }

 private:
  std::map<int, CutOutcome> made_;
};

}  // namespace blocks::run
