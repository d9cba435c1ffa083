// The materials of results, for messages.
#pragma once

#include <string>

#include "post/results_reader.hpp"

namespace blocks::post {

/// Lists the materials of all blocks with their names: "1 (stone), 2".
std::string material_list(const ResultsReader& results);

}  // namespace blocks::post
