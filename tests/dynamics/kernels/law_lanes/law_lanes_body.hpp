// Defines the function BLOCKS_ADVANCE of law_lanes.hpp with vectors of
// BLOCKS_LANES_AT_ONCE numbers.
#include "dynamics/kernels/law_lanes/law_lanes.hpp"

namespace blocks::dynamics {
namespace {

#if BLOCKS_LANES_AT_ONCE == 1
using Lanes = double;
#else
typedef double Lanes __attribute__((vector_size(BLOCKS_LANES_AT_ONCE * 8)));
#endif

template <template <class> class Of>
[[gnu::always_inline]] inline void load(Of<Lanes>& to, const double (*from)[8], int k) {
  char* const bytes = reinterpret_cast<char*>(&to);
  for (int row = 0; row < EightContacts::rows<Of>; ++row)
    __builtin_memcpy(bytes + row * sizeof(Lanes), &from[row][k], sizeof(Lanes));
}
template <template <class> class Of>
[[gnu::always_inline]] inline void store(const Of<Lanes>& from, double (*to)[8],
                                         int k) {
  const char* const bytes = reinterpret_cast<const char*>(&from);
  for (int row = 0; row < EightContacts::rows<Of>; ++row)
    __builtin_memcpy(&to[row][k], bytes + row * sizeof(Lanes), sizeof(Lanes));
}

}  // namespace

void BLOCKS_ADVANCE(EightContacts& contacts, LawBits kind, double dt) {
  for (int k = 0; k < 8; k += BLOCKS_LANES_AT_ONCE) {
    LawValues<Lanes> law;
    ContactMotion<Lanes> motion;
    ContactState<Lanes> state;
    ContactForce<Lanes> force;
    load(law, contacts.law, k);
    load(motion, contacts.motion, k);
    load(state, contacts.state, k);
    Lanes energy = {};
    each_law(
        kind, [&]<LawBits one>(std::integral_constant<LawBits, one>)
                  __attribute__((always_inline)) {
                    apply_law<one, true>(law, dt, motion, state, force);
                    energy = normal_energy<one>(law, state);
                  });
    energy += shear_energy(state);
    store(state, contacts.state, k);
    store(force, contacts.force, k);
    __builtin_memcpy(&contacts.energy[k], &energy, sizeof energy);
  }
}

}  // namespace blocks::dynamics
