// The records of CUT and MERGE cards as JSON, for the summary and `blocks check
// --geometry
// --json`.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "model/model.hpp"

namespace blocks::output {

/// Returns one object per CUT card. Blocks are counted from 1.
nlohmann::ordered_json cuts_json(const std::vector<CutRecord>& cuts,
                                 const std::vector<JointLengthRecord>& lengths);

/// Returns one object per block that another one has absorbed.
nlohmann::ordered_json merges_json(const std::vector<MergeRecord>& merges);

}  // namespace blocks::output
