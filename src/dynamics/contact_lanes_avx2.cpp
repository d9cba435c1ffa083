#define BLOCKS_LANES avx2
#define BLOCKS_LANES_AT_ONCE 4
#include "dynamics/contact_lanes_body.hpp"
#include "dynamics/facing_lanes_body.hpp"
