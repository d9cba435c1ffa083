// All kernels for one instruction set. Before it includes this file, a source file
// defines two macros: BLOCKS_INSTRUCTION_SET, which is also the namespace, and
// BLOCKS_LANES_AT_ONCE, the number of doubles in a register.
#include "dynamics/kernels/contact_kernel_body.hpp"
#include "dynamics/kernels/damping_kernel_body.hpp"
#include "dynamics/kernels/face_kernel_body.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "dynamics/kernels/motion_kernel_body.hpp"

#define BLOCKS_STRING(name) #name
#define BLOCKS_NAME_OF(name) BLOCKS_STRING(name)

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {

extern const Kernels kernels;
constinit const Kernels kernels = {BLOCKS_NAME_OF(BLOCKS_INSTRUCTION_SET),
                                   test_and_compute_forces,
                                   compute_forces,
                                   find_facing_sides,
                                   damp_unbalanced,
                                   update_velocities,
                                   update_strain,
                                   move};

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
