// Tells which faults may be consequences of cards that could not be read. Such faults
// are not reported.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "model/settings.hpp"

namespace blocks::run {

class UnreadCards {
 public:
  explicit UnreadCards(std::vector<deck::UnreadCard> cards)
      : cards_(std::move(cards)) {}

  bool has(std::string_view name) const;
  /// Whether one of the cards, or a MATERIAL card that is missing altogether, may
  /// define this material.
  bool may_define(long material, const Settings& settings) const;
  /// Whether one of the cards may be a JOINT card with this id; 0: with any id.
  bool may_define_joint(long id) const;

 private:
  std::vector<deck::UnreadCard> cards_;
};

}  // namespace blocks::run
