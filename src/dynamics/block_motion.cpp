#include "dynamics/block_motion.hpp"

#include "dynamics/contact_lanes.hpp"

namespace blocks::dynamics {

#define BLOCKS_DECLARE_MOTION(name)                                                    \
  namespace name {                                                                     \
  void update_velocities(const BlockColumns&, int, int, double, double, double);       \
  void update_strain(const BlockColumns&, const Moduli&, int, int, double);            \
  Moved move(const BlockColumns&, const SwingColumns&, const Rectangle&, bool, int,    \
             int, double);                                                             \
  constexpr MotionArithmetic motion = {#name, update_velocities, update_strain, move}; \
  }
BLOCKS_DECLARE_MOTION(baseline)
#ifdef BLOCKS_X86_LANES
BLOCKS_DECLARE_MOTION(avx2)
BLOCKS_DECLARE_MOTION(avx512)
#endif

const MotionArithmetic& motion_arithmetic(std::string_view name) {
#ifdef BLOCKS_X86_LANES
  for (const MotionArithmetic* wider : {&avx512::motion, &avx2::motion})
    if (wider->name == name)
      return *wider;
#endif
  return baseline::motion;
}

const MotionArithmetic& motion_arithmetic() {
  static const MotionArithmetic& chosen = motion_arithmetic(lane_arithmetic().name);
  return chosen;
}

}  // namespace blocks::dynamics
