#include "dynamics/contact_lanes.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace blocks::dynamics {

void ContactLanes::reserve(int sets, int slots) {
  const auto make = []<class Part>(int room, std::unique_ptr<Part[]>& own,
                                   Part*& part) {
    own.reset();  // not beside the new ones
    own = std::make_unique_for_overwrite<Part[]>(static_cast<std::size_t>(room));
    part = own.get();
  };
  if (sets > room_for_sets_) {
    make(sets, own_pairs_, pairs);
    make(sets, own_forces_, forces);
    make(sets, own_stresses_, stresses);
    room_for_sets_ = sets;
  }
  if (slots > room_for_slots_) {
    make(slots, own_places_, places);
    make(slots, own_springs_, springs);
    make(slots, own_advanced_, advanced);
    make(slots, own_readings_, readings);
    room_for_slots_ = slots;
  }
}

int ContactLanes::add_set(int slots) {
  pairs[sets_] = LanePairs{};
  pairs[sets_].first_slot = slots_;
  pairs[sets_].slots = slots;
  forces[sets_] = PairForces{};
  std::fill_n(places + slots_, slots, SlotPlaces{});
  std::fill_n(springs + slots_, slots, SlotSprings{});
  slots_ += slots;
  return sets_++;
}

int ContactLanes::set_of(int slot) const {
  const auto after =
      std::upper_bound(pairs, pairs + sets_, slot, [](int of, const LanePairs& set) {
        return of < set.first_slot;
      });
  return static_cast<int>(after - pairs) - 1;
}

#define BLOCKS_DECLARE_LANES(name)                                                     \
  namespace name {                                                                     \
  LaneExtremes touch_and_act(const LaneSets&, const BlockRows&, const ContactLaw&,     \
                             bool, bool, int, int);                                    \
  LaneExtremes act(const LaneSets&, const BlockRows&, const ContactLaw&, bool, bool,   \
                   int, int);                                                          \
  constexpr LaneArithmetic arithmetic = {#name, touch_and_act, act};                   \
  }
BLOCKS_DECLARE_LANES(baseline)
#ifdef BLOCKS_X86_LANES
BLOCKS_DECLARE_LANES(avx2)
BLOCKS_DECLARE_LANES(avx512)
#endif

const std::vector<LaneArithmetic>& all_lane_arithmetic() {
  static const std::vector<LaneArithmetic> all = [] {
    std::vector<LaneArithmetic> found = {baseline::arithmetic};
#ifdef BLOCKS_X86_LANES
    if (__builtin_cpu_supports("avx2"))
      found.push_back(avx2::arithmetic);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      found.push_back(avx512::arithmetic);
#endif
    return found;
  }();
  return all;
}

const LaneArithmetic& lane_arithmetic() {
  static const LaneArithmetic chosen = [] {
    const char* name = std::getenv("BLOCKS_SIMD");
    if (name == nullptr)
      return all_lane_arithmetic().back();
    std::string there;
    for (const LaneArithmetic& arithmetic : all_lane_arithmetic()) {
      if (arithmetic.name == name)
        return arithmetic;
      there += (there.empty() ? "" : ", ") + std::string(arithmetic.name);
    }
    throw std::invalid_argument("BLOCKS_SIMD=" + std::string(name) +
                                " is no instruction set of this machine; there are " +
                                there);
  }();
  return chosen;
}

}  // namespace blocks::dynamics
