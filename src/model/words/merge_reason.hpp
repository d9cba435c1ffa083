// Says in words why MERGE absorbed a block.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks {

/// Returns "0.125 < 0.2", with enough digits to distinguish the two. A block whose
/// width/height equals the limit is kept. If it is below the limit by less than doubles
/// resolve, the text says so.
std::string merge_reason(const MergeRecord& merge);

}  // namespace blocks
