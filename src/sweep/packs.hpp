// Packs of runs: what an engine gives to one of its tasks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace blocks::sweep {

/// Groups runs, given in ascending order, into packs of at most `size` runs, and
/// returns them in the form of --runs: "40-49", or "7" for a single run. Runs that are
/// left out between two of a pack have an outcome already.
std::vector<std::string> packs_of(const std::vector<std::size_t>& ids,
                                  std::size_t size);

/// Writes the packs, one per line. An older file that has other lines is kept as
/// PATH.bak, PATH.bak2, ... Throws files::FileError, also if the folder is a link.
void write_packs(const std::string& path, const std::vector<std::string>& packs);

/// Returns the lines of a file; none if it is missing. Throws files::FileError if it
/// is not a regular file.
std::vector<std::string> lines_of(const std::string& path);

}  // namespace blocks::sweep
