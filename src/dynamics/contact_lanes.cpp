#include "dynamics/contact_lanes.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "dynamics/huge_pages.hpp"

namespace blocks::dynamics {

void ContactLanes::reserve(const Room& room, bool rigid) {
  const auto make = []<class Part>(int count, std::unique_ptr<Part[]>& own,
                                   Part*& part) {
    own.reset();  // not beside the new ones
    own = std::make_unique_for_overwrite<Part[]>(static_cast<std::size_t>(count));
    part = own.get();
  };
  if (room.sets > room_.sets) {
    make(room.sets, own_pairs_, pairs);
    make(room.sets * lane_count, own_forces_, forces);
    prefer_huge_pages(forces, sizeof(PairForce) * room.sets * lane_count);
    room_.sets = room.sets;
  }
  if (room.slots > room_.slots) {
    make(room.slots, own_places_, places);
    make(room.slots, own_springs_, springs);
    make(room.slots, own_advanced_, advanced);
    room_.slots = room.slots;
  }
  if (room.read_slots > room_.read_slots) {
    make(room.read_slots, own_readings_, readings);
    room_.read_slots = room.read_slots;
  }
  if (const int count = rigid ? room.read_sets : room.sets;
      count > room_for_stresses_) {
    make(count * lane_count, own_stresses_, stresses);
    room_for_stresses_ = count;
  }
  first_stress = 0;
}

void ContactLanes::read_from(int set, bool rigid) {
  first_reading = pairs[set].first_slot;
  first_stress = rigid ? set : 0;
}

int ContactLanes::add_set(int slots) {
  pairs[sets_] = LanePairs{};
  pairs[sets_].first_slot = slots_;
  pairs[sets_].slots = slots;
  std::fill_n(forces + sets_ * lane_count, lane_count, PairForce{});
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
                             bool, int, int);                                          \
  LaneExtremes act(const LaneSets&, const BlockRows&, const ContactLaw&, bool, bool,   \
                   int, int);                                                          \
  void find_faces(const PartPairs&, const BlockRows&, FacingAnswers&);                 \
  constexpr LaneArithmetic arithmetic = {#name, touch_and_act, act, find_faces};       \
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
