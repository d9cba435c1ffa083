#define BLOCKS_LANES baseline
#define BLOCKS_LANES_AT_ONCE 2
#include "dynamics/block_motion_body.hpp"
