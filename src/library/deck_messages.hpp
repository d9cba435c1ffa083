// The messages of Diagnostics in the form of the C++ interface.
#pragma once

#include <algorithm>
#include <vector>

#include "blocks/simulation.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::library {

/// Returns all messages in the order of the lines of the deck; those of one line in the
/// order in which they were found.
inline std::vector<DeckMessage> messages_of(const deck::Diagnostics& diagnostics) {
  std::vector<deck::Diagnostic> sorted = diagnostics.all();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const deck::Diagnostic& l, const deck::Diagnostic& r) {
                     return l.where.line < r.where.line;
                   });
  std::vector<DeckMessage> messages;
  for (const deck::Diagnostic& one : sorted)
    messages.push_back({one.severity == deck::Severity::error, diagnostics.file(),
                        one.where.line, one.where.column, one.card, one.message,
                        one.hint, diagnostics.format(one)});
  return messages;
}

}  // namespace blocks::library
