// A pile of random polygons: no faces that fit, no order in the numbers of neighbours.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// Convex polygons of 4 to 8 corners and up to 1 [L] across, in ten layers one above
/// the other with small gaps, over a fixed floor between fixed sides; rigid,
/// gravity 9.81, friction 0.6, damping 0.5. The same for the same number. polygons > 0.
Model loose_pile(int polygons);

}  // namespace blocks::bench
