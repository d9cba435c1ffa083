// A location in a deck. Every field, command and message has one.
#pragma once

namespace blocks::deck {

/// Line and column count from 1; `length` is the number of characters that the caret
/// underlines.
struct SourceLocation {
  int line = 0;
  int column = 0;
  int length = 1;
};

}  // namespace blocks::deck
