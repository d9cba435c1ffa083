// The arithmetic of a step, compiled for each instruction set from one source. It uses
// no fused multiply-add and no reassociation, so all instruction sets give the same
// bits.
#pragma once

#include <string_view>
#include <vector>

#include "dynamics/kernels/contact_batch.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/face_kernel.hpp"
#include "dynamics/kernels/motion_kernel.hpp"

namespace blocks::dynamics {

/// The kernels for one instruction set. All ranges [begin, end) are half open.
struct Kernels {
  std::string_view name;  ///< baseline, avx2 or avx512

  /// Finds which tested contacts of the batches [begin, end) act and computes their
  /// forces. Unsettled batches (BatchMarks) are left out of the extremes. It has to be
  /// settled what acts there, and then `compute_forces` has to be called.
  Extremes (*test_and_compute_forces)(const BatchArrays&, const BlockState&,
                                      const ContactLaw&, bool rigid, int begin,
                                      int end);
  /// Computes the forces of the contacts whose `acts` bit is set. With `readings`,
  /// also writes ReadingRow, and PairStress of rigid blocks.
  Extremes (*compute_forces)(const BatchArrays&, const BlockState&, const ContactLaw&,
                             bool rigid, bool readings, int begin, int end);
  /// Finds which faces act, for eight pairs of convex parts (face_kernel.hpp).
  void (*find_facing_sides)(const PartPairs&, const BlockState&, FacingAnswers&);

  /// Local damping: subtracts from velocities, spins and strain rates. It has to
  /// precede the updates below.
  void (*damp_unbalanced)(const BlockColumns&, const LocalDamping&, bool rigid,
                          int begin, int end);
  /// (1), (2): updates velocities and spins. kick: StepMotion::kick.
  void (*update_velocities)(const BlockColumns&, int begin, int end, double gravity_x,
                            double gravity_y, double kick);
  /// (10), (12): updates strain rates and stresses. Materials and rates begin with
  /// those of block `begin`.
  void (*update_strain)(const BlockColumns&, const MaterialColumns&,
                        const VibrationDamping&, int begin, int end, double kick,
                        double dt);
  /// (3), (13)-(15): moves free and driven blocks, at most max_at_once. longest_arm and
  /// path: the columns of MotionBounds.
  Moved (*move)(const BlockColumns&, const double* longest_arm, double* path,
                const Rectangle& domain, bool rigid, int begin, int end, double dt);
};

/// Returns the kernels that this processor can run. The first is the baseline, the last
/// the widest.
const std::vector<Kernels>& all_kernels();

/// Returns the kernels that the environment variable BLOCKS_SIMD names, otherwise the
/// widest. The choice is made at the first call. Throws std::invalid_argument, with the
/// list of valid names, if this processor has no such instruction set.
const Kernels& kernels();

}  // namespace blocks::dynamics
