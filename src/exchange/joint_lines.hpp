// The sides of blocks that have a joint id, as lines for a drawing. Private to
// src/exchange.
#pragma once

#include <map>
#include <vector>

#include "exchange/block_record.hpp"

namespace blocks::exchange {

/// A side of a block, [L].
struct JointLine {
  geometry::Vec2 from, to;
};

/// Returns the sides by joint id, without those of id 0. A side that two blocks have in
/// common is there once; where one side is a part of another, both are there.
std::map<int, std::vector<JointLine>>
joint_lines(const std::vector<BlockRecord>& blocks);

}  // namespace blocks::exchange
