#define BLOCKS_ADVANCE advance_avx512
#define BLOCKS_LANES_AT_ONCE 8
#include "dynamics/kernels/law_lanes/law_lanes_body.hpp"
