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
  /// file: the name shown; text: the whole deck, kept to quote its lines.
  Diagnostics(std::string file, std::string text);

  void error(SourceLocation where, std::string card, std::string message,
             std::string hint = {});
  void warning(SourceLocation where, std::string card, std::string message,
               std::string hint = {});

  bool has_errors() const;
  const std::vector<Diagnostic>& all() const { return all_; }
  const std::string& file() const { return file_; }

  /// One message as printed, lines ended by '\n'.
  std::string format(const Diagnostic& diagnostic) const;
  /// All messages in the order of the deck's lines, then "2 errors, 1 warning".
  std::string format_all() const;

 private:
  std::string file_;
  std::string text_;
  std::vector<Diagnostic> all_;
};

}  // namespace blocks::deck
