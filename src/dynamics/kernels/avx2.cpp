#define BLOCKS_INSTRUCTION_SET avx2
#define BLOCKS_LANES_AT_ONCE 4
#include "dynamics/kernels/all_bodies.hpp"
