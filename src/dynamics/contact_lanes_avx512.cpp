#define BLOCKS_LANES avx512
#define BLOCKS_LANES_AT_ONCE 8
#include "dynamics/contact_lanes_body.hpp"
#include "dynamics/facing_lanes_body.hpp"
