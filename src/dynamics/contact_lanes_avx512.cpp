#define BLOCKS_LANES avx512
#include "dynamics/contact_lanes_body.hpp"
