// Splits well-known text into words, numbers and brackets. Private to src/exchange.
#pragma once

#include <string>
#include <string_view>

#include "exchange/ring.hpp"

namespace blocks::exchange {

/// Levels of nested collections that the readers accept.
inline constexpr int deepest_collection = 32;

/// A syntax error, which ends the reading.
struct SyntaxFault {
  std::size_t at;
  std::string message;
  std::size_t length;
  std::string hint = {};
};

/// A position in the text that moves forward. Blanks before each item are skipped.
class WktScanner {
 public:
  /// begin: offset of the first character to read.
  explicit WktScanner(std::string_view text, std::size_t begin = 0)
      : text_(text), at_(begin) {}

  /// Skips blanks and the characters of `also`, and returns the offset of what follows.
  std::size_t skip(std::string_view also = "");
  /// Tells whether nothing but blanks is left.
  bool is_at_end() { return skip() == text_.size(); }
  /// Tells whether the next character is `c`, without taking it.
  bool is_next(char c) { return !is_at_end() && text_[at_] == c; }

  /// Throws SyntaxFault: "expected ..., found ...".
  [[noreturn]] void fail(const std::string& expected, const std::string& hint = {});
  /// Takes the character if it is next.
  bool take(char c);
  /// Takes the character, or fails.
  void need(char c, const std::string& expected);
  /// Takes the next word and returns it in capitals; empty if there is none.
  std::string word();
  /// Takes the word EMPTY if it is next.
  bool take_empty();
  /// Takes the tag Z, M or ZM if it is next, and returns it; otherwise an empty text.
  std::string take_dimensions();
  /// Takes everything up to a blank, bracket, comma or semicolon; may be empty.
  WrittenNumber token();
  /// Takes a number of WKT, or fails. what: "a number, x".
  WrittenNumber number(const std::string& what, const std::string& hint = {});
  /// Tells whether a position goes on with another number.
  bool has_more() { return !is_at_end() && !is_next(',') && !is_next(')'); }
  /// Takes the third and the fourth number of a position, if it has them, or fails.
  void take_more_numbers();
  /// Continues at this offset.
  void move_to(std::size_t at) { at_ = at; }
  /// Takes the rest of "SRID=n;" up to the semicolon.
  void take_srid();

  /// Performs the action for each item of "( item, item, ... )".
  template <class Action> void list(Action action) {
    need('(', "'('");
    do
      action();
    while (take(','));
    need(')', "',' or ')'");
  }

 private:
  std::string_view text_;
  std::size_t at_;
};

}  // namespace blocks::exchange
