#include "run/builder/unread_cards.hpp"

#include <algorithm>

namespace blocks::run {

using deck::UnreadCard;

bool UnreadCards::has(std::string_view name) const {
  return std::any_of(cards_.begin(), cards_.end(),
                     [&](const UnreadCard& card) { return card.name == name; });
}

bool UnreadCards::may_define(long material, const Settings& settings) const {
  if (settings.materials.empty() && !has("MATERIAL"))
    return true;
  return has("RESTART") ||
         std::any_of(cards_.begin(), cards_.end(), [&](const UnreadCard& card) {
           return (card.name == "MATERIAL" &&
                   card.number.value_or(material) == material) ||
                  (card.name.empty() && card.number == material);
         });
}

bool UnreadCards::may_define_joint(long id) const {
  return has("RESTART") ||
         std::any_of(cards_.begin(), cards_.end(), [&](const UnreadCard& card) {
           return (card.name == "JOINT" &&
                   (id == 0 || card.number.value_or(id) == id)) ||
                  (card.name.empty() && card.number == id);
         });
}

long UnreadCards::max_blocks_above(int line) const {
  long max = 0;
  for (const UnreadCard& card : cards_)
    if (card.where.line < line)
      max = std::min(max + card.blocks, UnreadCard::any_number_of_blocks);
  return max;
}

const UnreadCard* UnreadCards::above(int line, std::size_t index) const {
  return index < cards_.size() && cards_[index].where.line < line ? &cards_[index]
                                                                  : nullptr;
}

}  // namespace blocks::run
