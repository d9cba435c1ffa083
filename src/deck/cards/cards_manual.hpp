// The deck reference as a man page, blocks-deck(5), generated from the card table.
#pragma once

#include <string>
#include <string_view>

namespace blocks::deck {

/// Returns the page in man(7) format. version: version of the program.
std::string card_reference_man(std::string_view version);

}  // namespace blocks::deck
