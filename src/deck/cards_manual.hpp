// The deck reference as a man page, blocks-deck(5), from the card table.
#pragma once

#include <string>
#include <string_view>

namespace blocks::deck {

/// The page in the language of man(7); version: of the program.
std::string card_reference_man(std::string_view version);

}  // namespace blocks::deck
