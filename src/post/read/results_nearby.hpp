// Suggests results files if the given file has no results.
#pragma once

#include <string>

namespace blocks::post {

/// Returns why the file cannot be results, such as "it is empty"; empty if it begins
/// like results.
std::string fault_of_head(const std::string& path);

/// Returns a line that names the results in the same folder, the newest first: "\n
/// hint: results in this folder: crater.vtkhdf, stack.vtkhdf". If there are none, the
/// line says how to make results.
std::string results_nearby(const std::string& path);

}  // namespace blocks::post
