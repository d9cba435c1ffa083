// Faults of the names of outputs, found before the work and not after it.
#pragma once

#include <string>
#include <vector>

namespace blocks::output {

/// Whether files of these names can be written; empty names count for nothing. Throws
/// FileError when one is a folder, its folder is missing or takes no files, or two are
/// the same. Nothing is opened: a full disk shows later.
void check_outputs(const std::vector<std::string>& paths);

}  // namespace blocks::output
