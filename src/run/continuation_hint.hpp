// How to continue from the checkpoint of a run that was stopped or is finished.
#pragma once

#include <string>

#include "run/run.hpp"

namespace blocks::run {

/// Returns the command that resumes a stopped run, to be copied into a shell. It
/// repeats the options that a restart must have in common with the run. `with_until`:
/// whether the time of --until is still ahead.
std::string continuation_command(const RunOptions& options,
                                 const std::string& checkpoint, bool with_until);

/// Returns the hint for --restart with the checkpoint of a finished run: the option
/// --until and a deck, both of which continue it for as long again. `time` is that of
/// the checkpoint.
std::string continuation_hint(const std::string& checkpoint, double time);

}  // namespace blocks::run
