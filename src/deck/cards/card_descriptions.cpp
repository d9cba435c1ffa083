#include "deck/cards/card_descriptions.hpp"

#include <fmt/format.h>

namespace blocks::deck {

std::string_view group_title(CardGroup group) {
  return group == CardGroup::preliminary ? "Preliminary cards, before END"
                                         : "Problem cards, in the order they act";
}

std::string_view kind_name(Kind kind) {
  switch (kind) {
  case Kind::integer:
    return "whole";
  case Kind::real:
    return "real";
  case Kind::exact:
    return "decimal";
  case Kind::word:
    return "word";
  case Kind::block:
    return "block";
  case Kind::side:
    return "side";
  }
  return "";
}

std::string default_text(const FieldSpec& field) {
  if (!field.fallback) {
    return "required";
  }
  return field.fallback->empty() ? "blank" : std::string(*field.fallback);
}

std::string range_text(const FieldSpec& field) {
  std::string out = field.range.text();
  for (const std::string_view choice : field.choices) {
    out += (out.empty() ? "" : ", ") + std::string(choice);
  }
  return out.empty() ? "any" : out;
}

std::string occurrence_text(const CardSpec& card) {
  std::string out = card.required ? "required" : "optional";
  if (card.group == CardGroup::preliminary) {
    out += card.once ? ", once" : ", may repeat";
  } else {
    out = "may repeat";
  }
  return out + (card.section == "ours" ? "; not in the report"
                                       : fmt::format("; report {}", card.section));
}

std::string sentence(std::string_view text) {
  std::string out(text);
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') {
    out[0] = static_cast<char>(out[0] - 'a' + 'A');
  }
  return out + ".";
}

}  // namespace blocks::deck
