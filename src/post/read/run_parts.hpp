// Finds out which results files are parts of one run. A run has several files if it was
// continued under another name or by a deck that begins with RESTART.
#pragma once

#include <string>
#include <vector>

namespace blocks::post {

/// One run and the files of its results.
struct RunParts {
  std::vector<std::string> files;  ///< in the order of time; the last one names the run
  unsigned long long seed = 0;     ///< of the last file
};

/// Groups results files, given in any order, by run. A file that two others continue is
/// a part of both runs. A file that goes on after its continuation begins is also a run
/// of its own. Throws std::runtime_error if a file cannot be read.
std::vector<RunParts> join_parts(const std::vector<std::string>& files);

}  // namespace blocks::post
