// The table of all cards. It defines parsing, defaults, ranges, spelling suggestions,
// --set and the deck reference (report Appendix A; docs/departures.md lists
// departures).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::deck {

enum class CardGroup { preliminary, problem };

/// Kind of value. `exact` is a decimal kept as written; `real` is its nearest double.
/// `block` and `side` are whole numbers or selectors.
enum class Kind { integer, real, exact, word, block, side };

/// The allowed values. The range includes its ends unless they are open.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;
  bool open_max = false;
  bool nonzero = false;

  bool contains(double value) const;
  /// Returns the range in words, such as "> 0 and <= 1" or "not 0"; empty if every
  /// number is allowed.
  std::string text() const;
};

/// One field of a card.
struct FieldSpec {
  std::string_view name;
  Kind kind = Kind::real;
  /// The default for a blank field; without one the field is required.
  std::optional<std::string_view> fallback;
  Range range;
  /// Dimension: "[L]", "[-]", ...
  std::string_view dimension;
  std::string_view help;
  std::vector<std::string_view> choices = {};  ///< allowed words; empty: any
  /// The field may be repeated: dtout, nb1, nb2, ... Only the last field may be.
  bool repeats = false;
};

/// Lines that follow a card, as described in the reference.
struct FollowOn {
  std::string_view syntax;
  std::string_view help;
};

/// One card. It continues on the next line if that line starts with a number and the
/// card has fewer than `continue_below` fields so far (0: never).
struct CardSpec {
  std::string_view name;
  CardGroup group = CardGroup::problem;
  bool once = false;
  bool required = false;
  std::string_view section;  ///< of the report; "ours" if not in the report
  std::string_view summary;
  std::vector<FieldSpec> fields;
  std::vector<FollowOn> follow_on = {};
  std::string_view notes = {};
  std::string_view example;
  std::size_t continue_below = 0;

  /// Returns the syntax, such as "BOXES, iboxes, jboxes, ctol".
  std::string syntax() const;
  /// Returns the index of the field with this name in any case, if it exists.
  std::optional<std::size_t> find_field(std::string_view field) const;
};

/// Returns all cards in the order of the report.
const std::vector<CardSpec>& card_table();

/// Returns the card with this name in any case, or null.
const CardSpec* find_card(std::string_view name);

/// Returns the names of all cards.
std::vector<std::string_view> card_names();

}  // namespace blocks::deck
