// On a sliding slope contacts pass from brick to brick in every layer.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// Four layers of bricks 1 x 0.5 [L], 1,000 in all, on a fixed floor of flush pieces
/// that falls by 20 degrees. Friction is 0.2, well below tan 20 = 0.36, so the layers
/// speed up for as long as the floor lasts, 500 [L]. Layer k, from 1, begins with the
/// velocity k [L/T] down the slope: friction is the same everywhere, so each layer
/// stays faster than the one below. Rigid, gravity 9.81, damping 0.5.
Model sliding_slope();

}  // namespace blocks::bench
