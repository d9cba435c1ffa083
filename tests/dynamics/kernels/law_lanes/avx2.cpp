#define BLOCKS_ADVANCE advance_avx2
#define BLOCKS_LANES_AT_ONCE 4
#include "dynamics/kernels/law_lanes/law_lanes_body.hpp"
