#define BLOCKS_INSTRUCTION_SET avx512
#define BLOCKS_LANES_AT_ONCE 8
#include "dynamics/kernels/all_bodies.hpp"
