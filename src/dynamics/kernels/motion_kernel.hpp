// The motion of blocks as the kernels see it: columns of numbers.
#pragma once

#include <cstdint>

namespace blocks {
enum class Fixity : int;
}

namespace blocks::dynamics {

/// Columns of Blocks that motion reads and writes.
struct BlockColumns {
  const int* first_corner;
  const Fixity* fixity;
  const double *area, *mass, *inertia, *force, *moment, *applied, *arm;
  double *corner, *centroid, *gradient, *angle, *velocity, *spin;
  double *stress, *strain_rate;
};
/// Elastic constants of (12), [F/L^2], of blocks one after the other.
struct Moduli {
  const double *c11, *c12;
  const double* twice_shear;  ///< 2 G
};
/// The domain, [L].
struct Rectangle {
  double lower_x, lower_y, upper_x, upper_y;
};

/// move() takes no more blocks at a time.
inline constexpr int most_at_once = 64;

/// What move() did.
struct Moved {
  double largest = 0.0;         ///< [L] as Displacement
  int block = -1;               ///< the first block that reached `largest`
  double bound = 0.0;           ///< [L] as Displacement
  double sum = 0.0;             ///< not a number, or infinite, if some corner is
  std::uint64_t near_edge = 0;  ///< bit k: block first + k may be outside the domain
};

}  // namespace blocks::dynamics
