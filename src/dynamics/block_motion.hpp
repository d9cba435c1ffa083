// Motion of blocks as plain arithmetic on their columns, compiled for each instruction
// set that the processor may have. No fused multiply-add, no reassociation: every set
// gives the same bits (tests/dynamics/block_motion_test.cpp).
#pragma once

#include <cstdint>
#include <string_view>

namespace blocks {
enum class Fixity : int;
}

namespace blocks::dynamics {

/// Columns of Blocks that motion reads and writes.
struct BlockColumns {
  const int* first_corner;
  const Fixity* fixity;
  const double *area, *mass, *inertia, *force, *moment, *applied;
  double *arm, *corner, *centroid, *angle, *velocity, *spin;
  double *stress, *strain_rate;
};
/// Columns of Swing.
struct SwingColumns {
  const double* longest;
  double *sum, *way, *shape;
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
  int block = -1;               ///< the first of which that is said
  double way = 0.0;             ///< [L] as Displacement
  double sum = 0.0;             ///< not a number, or infinite, if some corner is
  std::uint64_t near_edge = 0;  ///< bit k: block first + k may be outside the domain
};

/// The computations of motion.hpp for one instruction set: blocks first .. last - 1.
struct MotionArithmetic {
  std::string_view name;  ///< baseline, avx2, avx512
  /// (1), (2)
  void (*update_velocities)(const BlockColumns&, int first, int last, double gravity_x,
                            double gravity_y, double dt);
  /// (10), (12). The moduli are those of block `first` and the ones behind it.
  void (*update_strain)(const BlockColumns&, const Moduli&, int first, int last,
                        double dt);
  /// (3), (13)-(15)
  Moved (*move)(const BlockColumns&, const SwingColumns&, const Rectangle& domain,
                bool rigid, int first, int last, double dt);
};

/// For the instruction set of lane_arithmetic().
const MotionArithmetic& motion_arithmetic();
/// For the instruction set of this name, one of all_lane_arithmetic().
const MotionArithmetic& motion_arithmetic(std::string_view name);

}  // namespace blocks::dynamics
