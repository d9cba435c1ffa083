// What to do with the checkpoint of a run that is finished.
#pragma once

#include <string>

namespace blocks::run {

/// Returns the hint for --restart with the checkpoint of a finished run: the option
/// --until and a deck, both of which continue it for as long again. `time` is that of
/// the checkpoint.
std::string continuation_hint(const std::string& checkpoint, double time);

}  // namespace blocks::run
