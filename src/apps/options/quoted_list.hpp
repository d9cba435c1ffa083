// Lists of values in one option: -q speed,y:9 or --materials 1=RED,2=BLUE.
#pragma once

#include <string>
#include <vector>

namespace blocks::apps {

/// Splits each text at its commas, except at those within quotes or brackets, and
/// removes the quotes. As in a deck, a quote opens at the beginning of a value; here
/// also after `=`. Throws std::runtime_error if a quote is not closed.
std::vector<std::string> split_lists(const std::vector<std::string>& texts);

}  // namespace blocks::apps
