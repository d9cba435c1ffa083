#include "deck/known_materials.hpp"

#include <fmt/format.h>

#include "deck/card_reader.hpp"

namespace blocks::deck {

bool KnownMaterials::add(const Material& card, Diagnostics& diagnostics) {
  const auto [met, is_new] = numbers_.emplace(card.mat.value, card.mat.where.line);
  if (!is_new) {
    diagnostics.error(
        card.mat.where, "MATERIAL",
        fmt::format("material {} is defined twice", card.mat.value),
        met->second > 0 ? fmt::format("the first one is on line {}", met->second) : "");
  }
  if (card.name.value.empty()) {
    return is_new;
  }
  const std::string& name = card.name.value;
  const auto fault = [&](const std::string& message, const std::string& hint) {
    diagnostics.error(card.name.where, "MATERIAL", message, hint);
  };
  if (name.find(':') != std::string::npos) {
    fault(fmt::format("the name {} contains a colon", shown(name)),
          "a colon ends the name in quantities such as y:material=NAME:max");
  } else if (name.find_first_not_of("+-.0123456789") == std::string::npos) {
    fault(fmt::format("the name {} is a number", shown(name)),
          "in quantities such as y:material=2, a number is that of a material; add a "
          "letter to the name");
  }
  const auto [same, new_name] = names_.emplace(name, card.name.where.line);
  if (!new_name) {
    fault(fmt::format("two materials have the name {}", shown(name)),
          same->second > 0 ? fmt::format("the first one is on line {}", same->second)
                           : "");
  }
  return is_new;
}

}  // namespace blocks::deck
