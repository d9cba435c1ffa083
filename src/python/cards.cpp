// The table of cards, from which blocks.Deck makes its methods.
#include <string>

#include "bindings.hpp"
#include "deck/cards/card_table.hpp"

namespace blocks::python {
namespace {

const char* kind_of(deck::Kind kind) {
  switch (kind) {
  case deck::Kind::integer:
    return "whole";
  case deck::Kind::word:
    return "word";
  case deck::Kind::block:
    return "block";
  case deck::Kind::side:
    return "side";
  case deck::Kind::real:
  case deck::Kind::exact:
    break;
  }
  return "number";
}

py::dict dict_of(const deck::FieldSpec& field) {
  py::dict one;
  one["name"] = std::string(field.name);
  one["kind"] = kind_of(field.kind);
  one["default"] =
      field.fallback ? py::cast(std::string(*field.fallback)) : py::object(py::none());
  one["range"] = field.range.text();
  one["dimension"] = std::string(field.dimension);
  one["help"] = std::string(field.help);
  py::list choices;
  for (const std::string_view choice : field.choices)
    choices.append(std::string(choice));
  one["choices"] = choices;
  one["repeats"] = field.repeats;
  return one;
}

py::dict dict_of(const deck::CardSpec& card) {
  py::dict one;
  one["name"] = std::string(card.name);
  one["phase"] = card.group == deck::CardGroup::preliminary ? "preliminary" : "problem";
  one["once"] = card.once;
  one["required"] = card.required;
  one["summary"] = std::string(card.summary);
  one["syntax"] = card.syntax();
  one["notes"] = std::string(card.notes);
  one["example"] = std::string(card.example);
  py::list fields, lines;
  for (const deck::FieldSpec& field : card.fields)
    fields.append(dict_of(field));
  for (const deck::FollowOn& line : card.follow_on) {
    py::dict follows;
    follows["syntax"] = std::string(line.syntax);
    follows["help"] = std::string(line.help);
    lines.append(follows);
  }
  one["fields"] = fields;
  one["lines"] = lines;
  return one;
}

}  // namespace

void bind_cards(py::module_& module) {
  module.def(
      "card_table",
      [] {
        py::list cards;
        for (const deck::CardSpec& card : deck::card_table())
          cards.append(dict_of(card));
        return cards;
      },
      R"(card_table()
--

Returns all cards in the order of the reference, one dict for each.

Keys: name, phase, once, required, summary, syntax, notes, example, fields and lines (the
lines that follow the card). Keys of a field: name, kind, default, range, dimension, help,
choices, repeats.)");
}

}  // namespace blocks::python
