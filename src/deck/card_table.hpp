// The one table of all cards: it drives parsing, defaults, ranges, "did you mean",
// --set and the deck reference (report Appendix A; departures in docs/departures.md).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::deck {

enum class Phase { preliminary, problem };

/// exact: a decimal kept as written; real: its nearest double.
enum class Kind { integer, real, exact, word };

/// Values allowed; the ends belong to it unless open.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;
  bool open_max = false;
  bool nonzero = false;

  bool contains(double value) const;
  /// "> 0 and <= 1", "not 0"; empty when every number is allowed.
  std::string text() const;
};

struct FieldSpec {
  std::string_view name;
  Kind kind = Kind::real;
  /// Taken for a blank field; none: the field is required.
  std::optional<std::string_view> fallback;
  Range range;
  /// Dimension: "[L]", "[-]", ...
  std::string_view dimension;
  std::string_view help;
  std::vector<std::string_view> choices = {};  ///< words allowed; empty: any
  /// The last field of a card may repeat: dtout, nb1, nb2, ...
  bool repeats = false;
};

/// Lines that follow a card, for the reader of the reference.
struct FollowOn {
  std::string_view syntax;
  std::string_view help;
};

/// The card goes on on the next line when that starts with a number and fewer than
/// `continue_below` fields stand on it (0: never).
struct CardSpec {
  std::string_view name;
  Phase phase = Phase::problem;
  bool once = false;
  bool required = false;
  std::string_view section;  ///< of the report; "ours" for what it does not have
  std::string_view summary;
  std::vector<FieldSpec> fields;
  std::vector<FollowOn> follow_on = {};
  std::string_view notes = {};
  std::string_view example;
  std::size_t continue_below = 0;

  /// "BOXES, iboxes, jboxes, ctol"
  std::string syntax() const;
  /// Position of a field by its name in any case, if it exists.
  std::optional<std::size_t> find_field(std::string_view field) const;
};

/// All cards in the order of the report.
const std::vector<CardSpec>& card_table();

/// The card of that name in any case, or null.
const CardSpec* find_card(std::string_view name);

/// Names of all cards.
std::vector<std::string_view> card_names();

}  // namespace blocks::deck
