// Faults of the names of outputs, found before the work and not after it.
#pragma once

#include <string>
#include <vector>

namespace blocks::output {

/// Whether files of these names can be written; empty names count for nothing. Throws
/// FileError when one is a folder, its folder is missing or takes no files, or two are
/// the same. Nothing is opened: a full disk shows later.
void check_outputs(const std::vector<std::string>& paths);

/// For files that take their name when they are whole: what stands there would be
/// replaced or moved aside. Throws FileError when it is neither a regular file nor
/// nothing: a folder, a device, a fifo.
void expect_replaceable(const std::string& path);

}  // namespace blocks::output
