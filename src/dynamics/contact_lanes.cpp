#include "dynamics/contact_lanes.hpp"

#include <cstdlib>

namespace blocks::dynamics {

#define BLOCKS_DECLARE_LANES(name)                                                     \
  namespace name {                                                                     \
  void overlaps(OverlapLanes&);                                                        \
  void forces(ForceLanes&, const ContactLaw&, bool);                                   \
  constexpr ContactLanes lanes = {#name, overlaps, forces};                            \
  }
BLOCKS_DECLARE_LANES(baseline)
#ifdef BLOCKS_X86_LANES
BLOCKS_DECLARE_LANES(avx2)
BLOCKS_DECLARE_LANES(avx512)
#endif

const std::vector<ContactLanes>& all_contact_lanes() {
  static const std::vector<ContactLanes> all = [] {
    std::vector<ContactLanes> found = {baseline::lanes};
#ifdef BLOCKS_X86_LANES
    if (__builtin_cpu_supports("avx2"))
      found.push_back(avx2::lanes);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      found.push_back(avx512::lanes);
#endif
    return found;
  }();
  return all;
}

const ContactLanes& contact_lanes() {
  static const ContactLanes chosen = [] {
    if (const char* name = std::getenv("BLOCKS_SIMD"))
      for (const ContactLanes& lanes : all_contact_lanes())
        if (lanes.name == name)
          return lanes;
    return all_contact_lanes().back();
  }();
  return chosen;
}

}  // namespace blocks::dynamics
