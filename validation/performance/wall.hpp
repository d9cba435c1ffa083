// The scene by which speed is measured: a brick wall.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// A wall in running bond: rows of bricks 1 x 0.5 [L] between a fixed floor and fixed
/// sides, odd rows shifted by half a brick and closed with half bricks, `bricks` in an
/// even row. Rigid, gravity 9.81, friction 0.6, damping 0.5; free blocks are numbered
/// column by column, so that neighbours have near numbers. Has rows (bricks + 1/2)
/// free blocks. rows: even, > 0; bricks > 0. Throws std::invalid_argument.
Model wall(int rows, int bricks);

/// The wall of 10^power free blocks: 2^(power + 1) rows of (5^power - 1) / 2 bricks.
/// power: 1 to 7. Throws std::invalid_argument.
Model wall_of_power(int power);

}  // namespace blocks::bench
