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

}  // namespace blocks::run
