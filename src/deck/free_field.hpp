// The free-field reader (report: subroutine FFLD): deck text -> lines of fields, each
// with its place. Knows no card, except that START is followed by a title.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/source_location.hpp"
#include "geometry/decimal.hpp"

namespace blocks::deck {

/// What stands between two commas; blank when nothing does.
struct Field {
  std::string text;  ///< without quotes
  SourceLocation where;
  bool blank = false;
  bool quoted = false;
};

/// One line of the deck that holds at least one field.
struct Line {
  std::vector<Field> fields;
  SourceLocation end;  ///< just behind the last field
  bool comma = false;  ///< the line ends in a comma
  /// The next line of the deck, verbatim; only behind a START card.
  std::optional<std::string> title;
  SourceLocation title_where;

  /// The line holds values and continues a card: it starts with a number or a comma.
  bool is_data() const;
};

/// The physical lines of a deck without their ends (LF, CR LF or CR) and without a
/// UTF-8 byte order mark.
std::vector<std::string> source_lines(std::string_view text);

/// The characters of a line, one string each, so that columns count what an editor
/// shows. A byte that is not UTF-8 counts as one character and is shown as '?'.
std::vector<std::string> characters(std::string_view line);

/// The fields of one line: separated by commas or, where no comma stands, by blanks;
/// `$` and `!` start a comment; a comma at the end of the line adds nothing.
Line split_fields(std::string_view line, int number);

/// All lines that hold fields, with the title taken out behind START.
std::vector<Line> split_deck(std::string_view text);

/// In capitals (ASCII letters only).
std::string capitals(std::string_view text);

enum class NumberFault { none, not_a_number, not_finite, too_small };

struct Number {
  geometry::Decimal value;
  NumberFault fault = NumberFault::none;
};

/// Reads [+-]digits[.[digits]][exponent] with exponent (e|d)[+-]digits in any case or,
/// as Fortran does, a sign and digits: 1.5+3 is 1500. .5 and 5. count too. not_finite:
/// nan, inf or beyond the range of a double. too_small: not zero and below 1e-400,
/// where a double holds nothing.
Number read_number(std::string_view text);

/// The place of the first byte that no text file holds (NUL, control characters), if
/// any.
std::optional<SourceLocation> first_binary_byte(std::string_view text);

}  // namespace blocks::deck
