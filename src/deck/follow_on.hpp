// The lines of values behind a card: coordinates of CREATE, widths of LAYER, points of
// FUNCTION. Nothing is reserved by the count on the card: it may be anything.
#pragma once

#include <string_view>
#include <vector>

#include "deck/card_reader.hpp"

namespace blocks::deck {

/// Two lists of `count` values each, the second starting on a new line.
struct TwoListSpec {
  std::string_view card;
  long count = 0;
  std::string_view first, second;  ///< "x coordinates", "y coordinates"
  FieldSpec value;                 ///< of each value
  /// LAYER: one or two values will do, the last is repeated.
  bool may_be_short = false;
};

struct TwoLists {
  std::vector<Exact> first, second;
  bool ok = false;  ///< false after a fault, which has been reported
};

/// Splits the lines into the two lists. When the counts do not fit, the split that is
/// nearest to them is taken, so that the message names the list at fault. card_end:
/// just behind the card.
TwoLists read_two_lists(const TwoListSpec& spec, const std::vector<Line>& lines,
                        SourceLocation card_end, Diagnostics& diagnostics);

struct FunctionPoints {
  std::vector<Real> t, p;
  bool ok = false;
};

/// FUNCTION: `count` lines of t, p with times strictly rising.
FunctionPoints read_points(long count, const std::vector<Line>& lines,
                           SourceLocation card_end, Diagnostics& diagnostics);

}  // namespace blocks::deck
