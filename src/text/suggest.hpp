// Spelling suggestions: finds the nearest word of a list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blocks::text {

/// Returns the candidate nearest to the word in any case, or an empty string if none is
/// near. A candidate is near if few edits, relative to its length, lead to it, or if
/// one word begins with the other. A candidate that begins with the word is preferred.
/// Edits are to insert, delete or replace a letter or to swap neighbours.
std::string suggest(std::string_view word,
                    const std::vector<std::string_view>& candidates);

}  // namespace blocks::text
