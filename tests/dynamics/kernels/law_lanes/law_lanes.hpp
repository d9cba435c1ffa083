// Calls the laws of joints for eight contacts, with the vectors of one instruction set.
// This header includes nothing whose functions could be shared between instruction
// sets.
#pragma once

#include "dynamics/kernels/laws.hpp"

namespace blocks::dynamics {

/// Eight contacts, number by number. The rows are the members of the structures in
/// joint_contact.hpp, in their order.
struct EightContacts {
  template <template <class> class Of>
  static constexpr int rows = sizeof(Of<double>) / sizeof(double);

  alignas(64) double law[rows<LawValues>][8];
  alignas(64) double motion[rows<ContactMotion>][8];
  alignas(64) double state[rows<ContactState>][8];
  alignas(64) double force[rows<ContactForce>][8];
  alignas(64) double energy[8];
};

/// Advances eight contacts by one step with the law of a kind.
using AdvanceEight = void(EightContacts& contacts, LawBits kind, double dt);

AdvanceEight advance_one_by_one, advance_baseline;
#ifdef BLOCKS_X86_KERNELS
AdvanceEight advance_avx2, advance_avx512;
#endif

}  // namespace blocks::dynamics
