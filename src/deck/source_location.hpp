// A place in a deck: every field, command and message carries one.
#pragma once

namespace blocks::deck {

/// Line and column count from 1; length is what the caret underlines.
struct SourceLocation {
  int line = 0;
  int column = 0;
  int length = 1;
};

}  // namespace blocks::deck
