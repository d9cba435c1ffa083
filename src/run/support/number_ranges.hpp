// Writes lists of block numbers in short form.
#pragma once

#include <string>
#include <vector>

namespace blocks::run {

/// Returns block numbers as "2, 5 to 9 and 12 more". blocks: indices from 0, ascending.
std::string number_ranges(const std::vector<int>& blocks);

/// Returns the beginning of a sentence about blocks: "block 2 is", "blocks 5 to 9 are".
/// blocks: as for number_ranges, at least one.
std::string blocks_are(const std::vector<int>& blocks);

}  // namespace blocks::run
