// Joins the cards of a group OUTLINE ... CUT into the command CUT, and reports cards
// that are out of place in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/card_reader.hpp"
#include "deck/cards/card_lists.hpp"

namespace blocks::deck {

class CutGroup {
 public:
  /// Whether cards of this name belong to a group.
  static bool has(std::string_view card);

  /// The card as it was read.
  struct Part {
    std::string_view name;
    SourceLocation where;
    const Values& values;
    const std::vector<Line>& data;  ///< lines below the card
    SourceLocation end;             ///< just after the card
  };
  /// Takes the next card of a group. Returns the command at CUT if no card of the group
  /// had a fault. Faults are reported.
  std::optional<Cut> take(const Part& part, Diagnostics& diagnostics);

  /// Registers a card that is unknown. It may belong to the group, whose command is
  /// then not returned.
  void unknown() { sound_ = false; }

  /// Reports a group without CUT. next: the card that follows; empty at the end of the
  /// deck.
  void end_before(std::string_view next, Diagnostics& diagnostics);

 private:
  /// unfinished: the group had no CUT, so its later cards are not reported again.
  enum class State { outside, open, unfinished };
  bool begin(const Part& part, Diagnostics& diagnostics);
  bool add(const Part& part, Diagnostics& diagnostics);

  State state_ = State::outside;
  bool sound_ = true;  ///< no card of the group has a fault
  Cut cut_;
};

}  // namespace blocks::deck
