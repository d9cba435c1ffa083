// Reads the lines of values after a card: coordinates of CREATE, widths of LAYER,
// points of FUNCTION and WATER. No memory is reserved from the count on the card,
// because that may be any number.
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
  FieldSpec value;                 ///< specification of each value
  /// For LAYER: the list may have only one or two values, the last of which is
  /// repeated.
  bool may_be_short = false;
};

struct TwoLists {
  std::vector<Exact> first, second;
  bool ok = false;  ///< false after a fault, which has been reported
};

/// Splits the lines into the two lists. If the counts do not fit, it takes the split
/// nearest to them, so that the message names the list at fault. card_end: just after
/// the card.
TwoLists read_two_lists(const TwoListSpec& spec, const std::vector<Line>& lines,
                        SourceLocation card_end, Diagnostics& diagnostics);

/// Lines of two values, the points of a function.
struct PointSpec {
  std::string_view card;
  std::string_view count;   ///< name of the field that tells their number
  FieldSpec first, second;  ///< "t" and "p"
  /// What the first values are, if they must not decrease: "times".
  std::string_view ascending = {};
};

struct Points {
  std::vector<Real> first, second;
  bool ok = false;  ///< false after a fault, which has been reported
};

/// Reads `count` points, one on each line.
Points read_points(const PointSpec& spec, long count, const std::vector<Line>& lines,
                   SourceLocation card_end, Diagnostics& diagnostics);

}  // namespace blocks::deck
