// The sweeps of a report.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweep/plan.hpp"

namespace blocks::report {

/// One sweep of the report.
struct Member {
  std::string folder;  ///< as the user writes it
  std::string label;   ///< the last part of the folder, or more if labels would repeat
  sweep::Plan plan;
};

/// Returns the path of the results of a run, which need not exist.
std::string results_path(const Member& member, std::size_t id);

/// Reads the plans of the sweeps in these folders, at least one. Throws
/// files::FileError if a plan cannot be read. Throws std::runtime_error, with a hint,
/// if the sweeps have different decks, programs, numerics or ends, unless they are a
/// `pair` or `mixed`; also if a folder is named twice, or a pair has not two sweeps.
std::vector<Member> read_members(const std::vector<std::string>& folders, bool pair,
                                 bool mixed);

}  // namespace blocks::report
