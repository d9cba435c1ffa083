#define BLOCKS_LANES avx2
#define BLOCKS_LANES_AT_ONCE 4
#include "dynamics/block_motion_body.hpp"
