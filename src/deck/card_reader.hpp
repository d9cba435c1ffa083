// One card: its fields against the card table, with defaults, ranges and --set. Knows
// nothing of the order of cards.
#pragma once

#include <string>
#include <vector>

#include "deck/card_table.hpp"
#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "deck/free_field.hpp"
#include "deck/parser.hpp"

namespace blocks::deck {

/// A field that was read; `ok` is false after a fault, which has then been reported.
struct Value {
  SourceLocation where;  ///< the keyword when the default was taken
  bool given = false;
  bool ok = false;
  long integer = 0;
  geometry::Decimal number = {};
  std::string word = {};

  Int as_int() const { return {integer, where, given}; }
  Real as_real() const { return {number.value(), where, given}; }
  Exact as_exact() const { return {number, where, given}; }
  Word as_word() const { return {word, where, given}; }
};

/// All fields of a card, in the order of the table.
struct Values {
  std::vector<Value> fields;
  std::vector<Value> repeated;  ///< of the last field, when it repeats
  bool ok = true;               ///< no fault on this card
};

/// The overrides of the command line, split into fields.
struct OverrideFields {
  std::string card, field;  ///< capitals
  std::vector<Field> fields;
};

/// Checks the names of the overrides against the table; the good ones come back.
std::vector<OverrideFields> prepare_overrides(const std::vector<Override>& overrides,
                                              Diagnostics& diagnostics);

/// Reads one value by its specification.
Value read_value(const Field& field, const FieldSpec& spec, std::string_view card,
                 Diagnostics& diagnostics);

/// Reads a card: line.fields[0] is the keyword, the rest its values.
Values read_card(const CardSpec& spec, const Line& line,
                 const std::vector<OverrideFields>& overrides,
                 Diagnostics& diagnostics);

/// Text of a field for a message, quoted, shortened when long.
std::string shown(const std::string& text);

}  // namespace blocks::deck
