// The arithmetic of a step, compiled for each instruction set from one source. There is
// no fused multiply-add and no reassociation, so every instruction set gives the same
// bits.
#pragma once

#include <string_view>
#include <vector>

#include "dynamics/kernels/contact_batch.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/face_kernel.hpp"
#include "dynamics/kernels/motion_kernel.hpp"

namespace blocks::dynamics {

/// The kernels for one instruction set. Ranges are half open.
struct Kernels {
  std::string_view name;  ///< baseline, avx2 or avx512

  /// Finds which tested contacts of batches begin .. end-1 act and computes what they
  /// do. Batches in doubt are not among the extremes: their signs have to be decided
  /// exactly, and `act` repeated.
  Extremes (*touch_and_act)(const BatchArrays&, const BlockState&, const ContactLaw&,
                            bool rigid, int begin, int end);
  /// Computes what those contacts do that touch. With `readings` also ReadingRow, and
  /// PairStress of rigid blocks.
  Extremes (*act)(const BatchArrays&, const BlockState&, const ContactLaw&, bool rigid,
                  bool readings, int begin, int end);
  /// Finds which faces of eight pairs of convex parts act (face_kernel.hpp).
  void (*find_faces)(const PartPairs&, const BlockState&, FacingAnswers&);

  /// (1), (2)
  void (*update_velocities)(const BlockColumns&, int begin, int end, double gravity_x,
                            double gravity_y, double dt);
  /// (10), (12). The moduli are those of block `begin` and the blocks after it.
  void (*update_strain)(const BlockColumns&, const Moduli&, int begin, int end,
                        double dt);
  /// (3), (13)-(15), for at most most_at_once blocks. longest_arm: MotionBounds.
  Moved (*move)(const BlockColumns&, const double* longest_arm, const Rectangle& domain,
                bool rigid, int begin, int end, double dt);
};

/// The kernels that this processor can run. The first is the baseline, the last the
/// widest.
const std::vector<Kernels>& all_kernels();

/// The widest kernels, or those that the environment variable BLOCKS_SIMD names. Throws
/// std::invalid_argument, with the list of names, if this processor has no such
/// instruction set. The choice is made at the first call.
const Kernels& kernels();

}  // namespace blocks::dynamics
