// Many contacts at once, one to a SIMD lane: plain arithmetic on arrays, compiled for
// each instruction set that the processor may have. No fused multiply-add, no
// reassociation: every set gives the same bits (tests/dynamics/contact_lanes_test.cpp).
#pragma once

#include <string_view>
#include <vector>

#include "dynamics/contact_law.hpp"

namespace blocks::dynamics {

/// Contacts handled by one call.
inline constexpr int lane_count = 32;

using Lanes = double[lane_count];

/// Corners against edges: where they are, and how deep (19).
struct alignas(64) OverlapLanes {
  Lanes xc, yc, x1, y1, x2, y2;  ///< [L] in: corner, ends of the edge
  Lanes value, bound;  ///< [L^2] 2A and the bound of its error (docs/predicates.md)
  Lanes tangent_x, tangent_y;  ///< unit vector along the edge
  Lanes overlap;               ///< [L] >= 0
};

/// Acting contacts: rule 7. Side a is the corner's block, side b the edge's.
struct alignas(64) ForceLanes {
  // in
  Lanes tangent_x, tangent_y, overlap;       ///< of OverlapLanes
  Lanes arm_ax, arm_ay, arm_bx, arm_by;      ///< [L] from each centroid to the corner
  Lanes vax, vay, vbx, vby, spin_a, spin_b;  ///< [L/T], rad/T of both blocks
  Lanes rate_a[4], rate_b[4];                ///< 1/T strain rates 11, 12, 21, 22
  Lanes damping;                             ///< [F T/L] C of (18)
  Lanes starting;                            ///< 1: did not act in the step before
  // in and out
  Lanes normal_elastic, shear_elastic;  ///< [F]
  // out
  Lanes normal_force, shear_force;  ///< [F]
  Lanes fx, fy;                     ///< [F] on side a, the opposite on side b
  Lanes moment_a, moment_b;         ///< [F L]
  Lanes sums_a[4], sums_b[4];       ///< [F L] f_i x_j
};

/// The two computations for one instruction set.
struct ContactLanes {
  std::string_view name;  ///< baseline, avx2, avx512
  void (*overlaps)(OverlapLanes&);
  void (*forces)(ForceLanes&, const ContactLaw&, bool rigid);
};

/// All that this processor can run; the first is the baseline.
const std::vector<ContactLanes>& all_contact_lanes();

/// The widest of them, or what the environment variable BLOCKS_SIMD names.
const ContactLanes& contact_lanes();

}  // namespace blocks::dynamics
