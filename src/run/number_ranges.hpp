// Writes lists of block numbers in short form.
#pragma once

#include <string>
#include <vector>

namespace blocks::run {

/// Returns block numbers as "2, 5 to 9 and 12 more". blocks: indices from 0, ascending.
std::string number_ranges(const std::vector<int>& blocks);

}  // namespace blocks::run
