// A brick wall, the main scene of the benchmark.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

/// Returns a wall in running bond: rows of bricks 1 x 0.5 [L] between a fixed floor and
/// fixed sides. Even rows have `bricks` bricks; odd rows are shifted by half a brick
/// and closed with half bricks. The blocks are rigid, with gravity 9.81, friction 0.6
/// and damping 0.5. Free blocks are numbered column by column, so neighbours have
/// similar numbers. The wall has rows (bricks + 1/2) free blocks. Throws
/// std::invalid_argument unless rows is even and > 0 and bricks > 0.
Model wall(int rows, int bricks);

/// Returns the wall of 10^power free blocks: 2^(power + 1) rows of (5^power - 1) / 2
/// bricks. Throws std::invalid_argument unless 1 <= power <= 7.
Model wall_of_power(int power);

}  // namespace blocks::bench
