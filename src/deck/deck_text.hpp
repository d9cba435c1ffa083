// Whether a text can be a deck at all, before it is split into fields.
#pragma once

#include <string>

#include "deck/diagnostics.hpp"

namespace blocks::deck {

/// Reports a text in UTF-16 or UTF-32, one with control characters, one with sequence
/// numbers of punched cards, or one with a line of more than a million bytes. Returns
/// whether it is none of them.
bool is_deck_text(const std::string& text, Diagnostics& diagnostics);

/// Returns whether a word begins a comment of FORTRAN: C, CCC or C-----.
bool is_comment_of_fortran(const std::string& word);

}  // namespace blocks::deck
