// A sliding slope, where contacts pass from brick to brick in every layer.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// Returns four layers of bricks 1 x 0.5 [L], 1,000 in total, on a fixed floor of flush
/// pieces inclined by 20 degrees. Friction is 0.2, well below tan 20 = 0.36, so the
/// layers accelerate along the remaining 500 [L] of floor. Layer k, from 1, starts with
/// the velocity k [L/T] down the slope. Friction is the same everywhere, so each layer
/// remains faster than the one below. The blocks are rigid; gravity is 9.81, damping
/// 0.5.
Model sliding_slope();

}  // namespace blocks::bench
