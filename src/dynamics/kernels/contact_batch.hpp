// The data of contacts in the layout of the kernels. A batch is eight pairs of blocks,
// one pair to a SIMD lane. The contacts of a pair are in the rows of its batch, in its
// lane. A slot is one lane of one row.
#pragma once

#include "dynamics/kernels/contact_work.hpp"
#include "dynamics/kernels/joint_batch.hpp"

namespace blocks::dynamics {

/// The pairs of a batch. An idle lane has low = high.
struct alignas(64) BatchPairs {
  PerLane<int> low, high;   ///< the two blocks, the lower number first
  PerLane<double> damping;  ///< [F T/L] C of (18), the same for all contacts of a pair
  int first_row, rows;      ///< rows with the contacts of the batch
  bool has_laws;            ///< contacts may have laws of joints, in FaceRow
  LawBits laws;             ///< which they are
  int only_law;             ///< the law of all contacts of the batch; -1: several
};
/// What a step has found in a batch.
struct BatchMarks {
  bool ends;  ///< a contact has ceased to act
  /// The forces are not known yet: the kernel could not decide a sign or, if contacts
  /// may have laws of joints, some have begun or ceased to act.
  bool unsettled;
  bool receives;  ///< a contact has received a released spring
  bool breaks;    ///< a contact is bonded no longer
};

/// One contact of each pair of a batch, as corner numbers of the model. A slot whose
/// corner equals its edge is vacant.
struct ContactRow {
  PerLane<int> corner, edge, edge_end;
};
/// How the contacts of a row are decided. A contact that is neither tested nor certain
/// acts only if a bond or an offset holds it, or if it takes over a spring.
struct ContactTests {
  LaneBits tested;       ///< it acts if its corner is inside (19) and between the ends
  LaneBits certain;      ///< it acts: the exact rule has decided it for this step
  LaneBits edge_is_low;  ///< the edge, not the corner, belongs to the low block
};
/// Which contacts of a row act in a step.
struct ContactStates {
  /// It acts in this step. Until it is tested: it acted in the step before.
  LaneBits acts;
  LaneBits starts;  ///< it did not act in the step before, or has taken over a spring
  LaneBits ends;    ///< it acted in the step before and does not act now
  /// It is taken to act, but a sign is too close to zero for doubles.
  LaneBits in_doubt;
};
/// The springs of the contacts of a row. They are kept from step to step.
struct alignas(64) SpringRow {
  PerLane<double> normal_elastic, shear_elastic;  ///< [F]
};
/// The total force of the contacts of a pair on its two blocks in a step.
struct alignas(32) PairForce {
  double fx, fy;                   ///< [F] on the low block
  double moment_low, moment_high;  ///< [F L] about the centroids of the two blocks
};
/// The sums of f_i x_j for the two blocks of a pair, in the order 11, 12, 21, 22,
/// [F L]. Each arm x begins at the block's own centroid.
struct alignas(64) PairStress {
  double low[4], high[4];
};
/// What the contacts of a pair do with the work of its two blocks in a step.
using PairWork = ContactWork<double>;
/// Results that are needed for output only.
struct alignas(64) ReadingRow {
  PerLane<double> overlap;                    ///< [L] >= 0
  PerLane<double> normal_force, shear_force;  ///< [F] 0 if the contact does not act
};

/// The arrays of all batches. The memory belongs to ContactBatches. Kernels write to it
/// through a constant BatchArrays.
struct BatchArrays {
  BatchPairs* pairs = nullptr;     ///< (batches)
  BatchMarks* marks = nullptr;     ///< (batches)
  PairForce* forces = nullptr;     ///< (batches * lane_count)
  PairStress* stresses = nullptr;  ///< (batches * lane_count) if rigid, for output only
  PairWork* works = nullptr;       ///< (batches * lane_count) if has_account
  ContactRow* contacts = nullptr;  ///< (rows)
  ContactTests* tests = nullptr;   ///< (rows)
  ContactStates* states = nullptr;  ///< (rows)
  SpringRow* springs = nullptr;     ///< (rows) at the start of the step
  SpringRow* advanced = nullptr;    ///< (rows) at the end of the step
  ReadingRow* readings = nullptr;   ///< (rows) for output only
  // Only in models with laws of joints or INSITU.
  FaceRow* faces = nullptr;               ///< (rows)
  DashpotRow* dashpots = nullptr;         ///< (rows)
  LawRow* law_states = nullptr;           ///< (rows) at the start of the step
  LawRow* advanced_law_states = nullptr;  ///< (rows) at the end of the step
  LawColumns laws;
  bool has_account = false;  ///< the model keeps an energy account
};

/// The largest values of all contacts that act in a step.
struct Extremes {
  double overlap = 0.0;  ///< [L]
  double spring = 0.0;   ///< [F] elastic normal force
  void include(const Extremes& other) {
    overlap = other.overlap > overlap ? other.overlap : overlap;
    spring = other.spring > spring ? other.spring : spring;
  }
};

/// The columns of Blocks from which contacts are computed.
struct BlockState {
  const double *corner, *centroid, *velocity, *spin, *strain_rate;
};

}  // namespace blocks::dynamics
