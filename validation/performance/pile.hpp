// A pile of random polygons, with no matching faces and no order in the numbering.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// Returns convex polygons of 4 to 8 corners and up to 1 [L] across, in ten layers with
/// small gaps, over a fixed floor and between fixed sides. They are rigid, with gravity
/// 9.81, friction 0.6 and damping 0.5. The same number always gives the same pile.
/// polygons > 0.
Model loose_pile(int polygons);

}  // namespace blocks::bench
