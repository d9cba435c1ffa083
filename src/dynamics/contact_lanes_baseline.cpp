#define BLOCKS_LANES baseline
#define BLOCKS_LANES_AT_ONCE 2
#include "dynamics/contact_lanes_body.hpp"
#include "dynamics/facing_lanes_body.hpp"
