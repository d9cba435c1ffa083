// The targets of the scenes.
#pragma once

#include "report.hpp"

namespace blocks::bench {

/// Adds the targets of the calm walls whose rows are in the report.
void add_wall_targets(Report& report);

}  // namespace blocks::bench
