// Checks the names of output files before the work begins.
#pragma once

#include <string>
#include <vector>

namespace blocks::files {

/// Checks that files with these names can be written; empty names are ignored. Throws
/// FileError if a name is a folder, its folder is missing or not writable, or two names
/// are the same. No file is opened, so a full disk is not detected.
void check_outputs(const std::vector<std::string>& paths);

}  // namespace blocks::files
