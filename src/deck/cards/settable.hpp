// What --set can change in a deck.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blocks::deck {

/// Returns the fields of all cards of a deck with their values in the form that --set
/// takes: "MATERIAL[2].rho=2500". The number is left out if the card is the only one of
/// its kind. A field that the deck leaves blank has its default. The deck has no
/// faults. Titles and the lists of values below a card cannot be set.
std::vector<std::string> settable_fields(std::string_view text);

}  // namespace blocks::deck
