// The targets of the scenes.
#pragma once

#include "report.hpp"

namespace blocks::bench {

/// Adds the targets of the calm walls whose rows are in the report.
void add_wall_targets(Report& report);
/// Adds the target of a settling pile against Box2D.
void add_pile_target(Report& report, int polygons);

}  // namespace blocks::bench
