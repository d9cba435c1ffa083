// The data of contacts with the laws of joints, in the layout of the kernels
// (contact_batch.hpp). Only models with laws or INSITU have these arrays.
#pragma once

#include <cstdint>

#include "dynamics/kernels/laws.hpp"

namespace blocks::dynamics {

/// The number of lanes of a batch. It is one register of AVX-512, or two of AVX2.
inline constexpr int lane_count = 8;
/// One number for each lane of a batch.
template <class Number> using PerLane = Number[lane_count];
/// One bit for each lane of a batch. Bit k belongs to lane k.
using LaneBits = std::uint8_t;

/// The law and the faces of the contacts of a row. The side before a corner and the
/// side after it may each form a face with the edge. The partner of a contact is the
/// one at the same end of the face: the end of the edge that acts on this side.
struct FaceRow {
  PerLane<int> law;            ///< column of LawColumns
  PerLane<int> before, after;  ///< corners of the block next to the corner
  /// row, counted in the batch, of the partner; -1: none
  PerLane<short> partner_before, partner_after;
  /// The partner acts too, so each stands for half of the end.
  LaneBits shared_before, shared_after;
};
/// Roots that the dashpots of a row need. They stay as long as the stiffnesses.
struct alignas(64) DashpotRow {
  PerLane<double> stiffness;  ///< [F/L] of the contacts
  PerLane<double> root;       ///< of the stiffness over that of STIFF
};

/// What laws remember of the contacts of a row (LawState of the model). Flags are 1
/// or 0.
struct alignas(64) LawRow {
#define BLOCKS_MEMBER(member, ...) PerLane<double> member;
  BLOCKS_LAW_STATES(BLOCKS_MEMBER)
#undef BLOCKS_MEMBER
};

/// The values of all laws, law by law. Law 0 is that of STIFF and FRICTN.
struct LawColumns {
  LawValues<const double*> values = {};
  const double* kind = nullptr;  ///< bit of the law's kind, as a number
};

}  // namespace blocks::dynamics
