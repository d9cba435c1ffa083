// The data of blocks in the layout of the motion kernels: columns of numbers.
#pragma once

#include <cstdint>

namespace blocks {
enum class Fixity : int;
}

namespace blocks::dynamics {

/// A block moves if its fixity has no other bit: it is free or driven.
inline constexpr int driven_bit = 4;

/// The columns of Blocks that the motion kernels read and write.
struct BlockColumns {
  const int* first_corner;
  const Fixity* fixity;
  const double *area, *mass, *inertia, *second_moment;
  const double *force, *moment, *applied, *arm;
  const double* scale;  ///< inertial mass over mass; null: 1
  double *corner, *centroid, *gradient, *angle, *velocity, *spin;
  double *stress, *strain_rate;
};
/// Constants of the materials of successive blocks. Those of fixed blocks are not used.
struct MaterialColumns {
  const double *c11, *c12;    ///< [F/L^2] of (12)
  const double* twice_shear;  ///< [F/L^2] 2 G
  /// [(F/L^2)^1/2] 2 z sqrt(C11); 0: no damping of vibration
  const double* damping;
};
/// A motion that is slower than this part of its loss by local damping in a step has
/// its direction from rounding, and is not damped.
inline constexpr double slow_motion = 0x1p-20;
/// What local damping needs to know of a step (docs/rest.md#local-damping).
struct LocalDamping {
  double alpha_dt;              ///< [T] alpha times the time step
  double gravity_x, gravity_y;  ///< [L/T^2]
  double* work;  ///< [F L] (n) receives the energy taken from each block, or null
};
/// What the damping of vibration needs to know of a step
/// (docs/cracks.md#damping-of-vibration).
struct VibrationDamping {
  /// 1/T (4, n) strain rates of the blocks before the step; null: no block is damped
  const double* rates;
  double* work;  ///< [F L] (n) the energy taken from each block is added to it; or null
};
/// The domain, [L].
struct Rectangle {
  double lower_x, lower_y, upper_x, upper_y;
};

/// The smaller principal second moment of a block counts as at least this part of the
/// mean of both. This concerns slivers thinner than about a millionth of their length,
/// whose smaller moment is lost in round-off.
inline constexpr double min_moment_share = 1e-12;

/// The largest number of blocks in one call of move().
inline constexpr int max_at_once = 64;

/// Results of move().
struct Moved {
  double largest = 0.0;         ///< [L] see Displacement::largest
  int block = -1;               ///< the first block that reached `largest`
  double bound = 0.0;           ///< [L] see Displacement::bound
  double sum = 0.0;             ///< NaN or infinite if some corner is not finite
  std::uint64_t near_edge = 0;  ///< bit k: block begin + k may be outside the domain
};

}  // namespace blocks::dynamics
