#define BLOCKS_LANES avx512
#define BLOCKS_LANES_AT_ONCE 8
#include "dynamics/block_motion_body.hpp"
