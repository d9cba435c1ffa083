// Collects the errors and warnings of a deck, all in one pass, and prints them in the
// form editors can click: file:line:col: error: CARD: message, the line, a caret, a
// hint.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deck/source_location.hpp"

namespace blocks::deck {

enum class Severity { error, warning };

struct Diagnostic {
  Severity severity = Severity::error;
  SourceLocation where;
  std::string card;     ///< the card concerned, capitals; empty for the deck as a whole
  std::string message;  ///< lower case, no full stop
  std::string hint;     ///< may be empty
};

/// Messages about one deck.
class Diagnostics {
 public:
  /// file: the name shown; text: the whole deck, whose lines are quoted. A message at
  /// line 0 concerns the deck as a whole.
  Diagnostics(std::string file, std::string text);

  void error(SourceLocation where, std::string card, std::string message,
             std::string hint = {});
  void warning(SourceLocation where, std::string card, std::string message,
               std::string hint = {});

  /// The place of a value that does not stand in the deck; option as the user typed it,
  /// "--set CARD.field=value". Messages there start with the option instead of the
  /// file.
  SourceLocation from_command_line(std::string option);

  bool has_errors() const;
  const std::vector<Diagnostic>& all() const { return all_; }
  const std::string& file() const { return file_; }

  /// One message as printed, lines ended by '\n'.
  std::string format(const Diagnostic& diagnostic) const;
  /// All messages in the order of the deck's lines, then "2 errors, 1 warning"; the
  /// first 200 of them if there are more. Empty when there are none.
  std::string format_all() const;

 private:
  void add(Diagnostic diagnostic);

  std::string file_;
  std::vector<std::string> lines_;    ///< of the deck
  std::vector<std::string> options_;  ///< a place on line 0 has its number as column
  std::vector<Diagnostic> all_;
};

}  // namespace blocks::deck
