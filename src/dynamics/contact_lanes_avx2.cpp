#define BLOCKS_LANES avx2
#include "dynamics/contact_lanes_body.hpp"
