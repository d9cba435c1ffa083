// The materials of results.
#pragma once

#include <set>
#include <string>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// Returns the materials of all blocks.
std::set<int> materials_of(const ResultsReader& results);

/// Lists the materials of all blocks with their names: "1 (stone), 2".
std::string material_list(const ResultsReader& results);

}  // namespace blocks::post
