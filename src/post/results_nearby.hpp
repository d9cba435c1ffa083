// What to read instead of a file that holds no results.
#pragma once

#include <string>

namespace blocks::post {

/// Why the file cannot hold results, "it is empty"; empty when it begins like one.
std::string fault_of_head(const std::string& path);

/// A line that names the results beside the file, the newest first, or says where
/// results come from: "\n  hint: results here: crater.vtkhdf, stack.vtkhdf".
std::string results_nearby(const std::string& path);

}  // namespace blocks::post
