// The record of a CUT card in words, for `blocks check` and the listing.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks {

/// Returns some lines: the blocks and their certificate, what was pruned of each joint
/// id, the vertices, and what cleaning did. lengths: of all cards.
std::string cut_report(const CutRecord& cut,
                       const std::vector<JointLengthRecord>& lengths);

}  // namespace blocks
