#define BLOCKS_LANES baseline
#include "dynamics/contact_lanes_body.hpp"
