#define BLOCKS_INSTRUCTION_SET baseline
#define BLOCKS_LANES_AT_ONCE 2
#include "dynamics/kernels/all_bodies.hpp"
