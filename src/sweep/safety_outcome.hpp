// The factor of safety in the outcome of a run: what the FOS card proved.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace blocks::sweep {

/// Returns {"lower": 1.39, "upper": 1.4} of the summary of a run (NAME.summary.json);
/// an end that no trial proved is null. Returns null if the deck has no FOS card, or
/// the summary cannot be read.
nlohmann::ordered_json safety_outcome(const std::string& summary_path);

}  // namespace blocks::sweep
