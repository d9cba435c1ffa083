// "Did you mean": the nearest of a list of words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blocks::deck {

/// The candidate nearest to the word, or empty when none is near. Case does not
/// matter. Near means few edits (insert, delete, replace, swap neighbours) for the
/// length, or one word beginning with the other.
std::string suggest(std::string_view word,
                    const std::vector<std::string_view>& candidates);

}  // namespace blocks::deck
