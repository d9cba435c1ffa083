#define BLOCKS_ADVANCE advance_one_by_one
#define BLOCKS_LANES_AT_ONCE 1
#include "dynamics/kernels/law_lanes/law_lanes_body.hpp"
