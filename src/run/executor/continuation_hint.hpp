// How to continue from the checkpoint of a run that was stopped or is finished.
#pragma once

#include <string>

#include "run/support/run_options.hpp"

namespace blocks::run {

/// Returns the command that resumes a stopped run, to be copied into a shell. It
/// repeats the options that a restart must have in common with the run. `with_until`:
/// whether the time of --until is still ahead.
std::string continuation_command(const RunOptions& options,
                                 const std::string& checkpoint, bool with_until);

/// Returns the hint for --restart with the checkpoint of a finished run. It shows two
/// ways to continue until twice the time of the checkpoint, `time` [T]: the option
/// --until, and a deck that begins with RESTART.
std::string continuation_hint(const std::string& checkpoint, double time);

}  // namespace blocks::run
