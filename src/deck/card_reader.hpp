// Reads the fields of one card according to the card table, with defaults, ranges and
// --set. Independent of the order of cards.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/cards/card_table.hpp"
#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "deck/free_field.hpp"
#include "deck/parser.hpp"

namespace blocks::deck {

/// The value of a field. `ok` is false after a fault, which has then been reported.
struct Value {
  SourceLocation where;  ///< the keyword if the default was used
  bool given = false;
  bool ok = false;
  long integer = 0;
  geometry::Decimal number = {};
  std::string word = {};
  std::optional<Selector> selector = {};

  NumberOrSelector as_choice() const { return {as_int(), selector}; }
  Int as_int() const { return {integer, where, given}; }
  Real as_real() const { return {number.value(), where, given}; }
  Exact as_exact() const { return {number, where, given}; }
  Word as_word() const { return {word, where, given}; }
};

/// All fields of a card, in the order of the table.
struct Values {
  std::vector<Value> fields;
  std::vector<Value> repeated;  ///< values of the last field, if it repeats
  bool ok = true;               ///< the card has no fault
};

/// An override of the command line, split into fields.
struct OverrideFields {
  std::string card, field;  ///< in capitals
  long number = 0;          ///< MATERIAL[2]: the second card of its kind; 0: every one
  std::vector<Field> fields;

  /// Whether it changes the card of this name that is the `nth` of its kind, from 1.
  bool changes(std::string_view name, long nth) const {
    return card == name && (number == 0 || number == nth);
  }
};

/// Checks the names of the overrides against the table and returns the valid ones.
std::vector<OverrideFields> prepare_overrides(const std::vector<Override>& overrides,
                                              Diagnostics& diagnostics);

/// Reads one value according to its specification.
Value read_value(const Field& field, const FieldSpec& spec, std::string_view card,
                 Diagnostics& diagnostics);

/// Reads a card, the `nth` of its kind in the deck (from 1). line.fields[0] is the
/// keyword; the other fields are its values.
Values read_card(const CardSpec& spec, const Line& line, long nth,
                 const std::vector<OverrideFields>& overrides,
                 Diagnostics& diagnostics);

/// Joins the card at lines[next] with its continuation lines, and moves `next` behind
/// them.
Line take_card(const CardSpec& spec, const std::vector<Line>& lines, std::size_t& next);

/// Returns the text of a field for a message: quoted, and shortened if long.
std::string shown(const std::string& text);

}  // namespace blocks::deck
