#define BLOCKS_ADVANCE advance_baseline
#define BLOCKS_LANES_AT_ONCE 2
#include "dynamics/kernels/law_lanes/law_lanes_body.hpp"
