// The free-field reader (report: subroutine FFLD): splits deck text into lines of
// fields with their locations. Independent of the cards, except that a title follows
// START.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/source_location.hpp"
#include "geometry/decimal.hpp"

namespace blocks::deck {

enum class QuoteFault {
  none,
  not_closed,  ///< there is no closing quote
  text_after   ///< more text follows the closing quote
};

/// The text between two commas; blank if there is none. A field whose quotes are faulty
/// extends to the end of the line, with its quotes.
struct Field {
  std::string text;  ///< without quotes
  SourceLocation where;
  bool blank = false;
  bool quoted = false;
  QuoteFault fault = QuoteFault::none;
};

/// One line of the deck that holds at least one field.
struct Line {
  std::vector<Field> fields;
  SourceLocation end;  ///< just after the last field
  bool comma = false;  ///< the line ends in a comma
  /// The next line of the deck, verbatim; only after a START card.
  std::optional<std::string> title;
  SourceLocation title_where;

  /// Tells whether the line holds values and continues a card: it starts with a number
  /// or a comma.
  bool is_data() const;
};

/// The hint where a line looks like a comment of another program.
inline constexpr const char* comment_hint = "a comment begins with $ or !";

/// Returns the lines of a deck without their line ends (LF, CR LF or CR) and without a
/// UTF-8 byte order mark.
std::vector<std::string> source_lines(std::string_view text);

/// Whether all bytes of the text belong to characters of UTF-8.
bool is_utf8(std::string_view text);

/// Returns the characters of a line, one string each, so that columns count what an
/// editor shows. A byte that is not valid UTF-8 counts as one character and is shown as
/// '?'.
std::vector<std::string> characters(std::string_view line);

/// Splits one line into fields, separated by commas or, between commas, by blanks. `$`
/// and `!` start a comment. A comma at the end of the line adds no field. Commas and
/// blanks between the brackets of a selector do not separate fields.
Line split_fields(std::string_view line, int number);

/// Returns all lines that hold fields. The title after START is stored in the START
/// line.
std::vector<Line> split_deck(std::string_view text);

enum class NumberFault { none, not_a_number, not_finite, too_small };

struct Number {
  geometry::Decimal value;
  NumberFault fault = NumberFault::none;
};

/// Reads [+-]digits[.[digits]][exponent]; .5 and 5. are also numbers. The exponent is
/// (e|d)[+-]digits in any case or, as in Fortran, a sign and digits: 1.5+3 is 1500.
/// Faults: not_finite for nan, inf or a value beyond the range of doubles; too_small
/// for a nonzero value below 1e-400, which no double resolves.
Number read_number(std::string_view text);

/// Returns the location of the first byte that no text file contains (NUL, control
/// characters), if any.
std::optional<SourceLocation> first_binary_byte(std::string_view text);

}  // namespace blocks::deck
