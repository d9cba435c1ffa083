// These are the targets of the scenes.
#pragma once

#include "report.hpp"

namespace blocks::bench {

/// Adds the targets of the calm walls, as far as their rows are there.
void add_wall_targets(Report& report);

}  // namespace blocks::bench
