// Collects the errors and warnings of a deck in one pass and prints them in the form
// that editors recognise: file:line:col: error: CARD: message, the line, a caret, a
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
  std::string card;     ///< card at fault, in capitals; empty: the whole deck
  std::string message;  ///< lower case, no full stop
  std::string hint;     ///< may be empty
};

/// The messages about one deck.
class Diagnostics {
 public:
  /// file: the name shown in messages. text: the whole deck, whose lines are quoted. A
  /// message at line 0 concerns the deck as a whole.
  Diagnostics(std::string file, std::string text);

  void error(SourceLocation where, std::string card, std::string message,
             std::string hint = {});
  void warning(SourceLocation where, std::string card, std::string message,
               std::string hint = {});

  /// Returns a location for a value that is not in the deck but in an option, as the
  /// user typed it: "--set CARD.field=value". Messages at this location start with the
  /// option instead of the file.
  SourceLocation from_command_line(std::string option);

  bool has_errors() const;
  const std::vector<Diagnostic>& all() const { return all_; }
  const std::string& file() const { return file_; }

  /// Returns one message as printed; every line ends with '\n'.
  std::string format(const Diagnostic& diagnostic) const;
  /// Returns all messages in the order of the deck's lines, at most the first 100, then
  /// "2 errors, 1 warning". Empty if there are none.
  std::string format_all() const;

 private:
  void add(Diagnostic diagnostic);

  std::string file_;
  std::vector<std::string> lines_;  ///< lines of the deck
  /// Options of the command line; the column of a location on line 0 is the number of
  /// its option.
  std::vector<std::string> options_;
  std::vector<Diagnostic> all_;
};

}  // namespace blocks::deck
