// Every instruction set gives the same bits.
#include "dynamics/contact_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <numeric>
#include <random>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

using geometry::Vec2;

/// Numbers of every size, of both signs, and zeros.
class Numbers {
 public:
  double any() {
    return kind_(random_) == 0 ? 0.0 : std::ldexp(uniform_(random_), power_(random_));
  }
  double positive() { return std::abs(uniform_(random_)) + 0x1p-20; }
  int below(int count) { return static_cast<int>(random_() % count); }

 private:
  std::mt19937_64 random_{11};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::uniform_int_distribution<int> power_{-30, 30}, kind_{0, 9};
};

/// Contacts of no shape in particular between blocks of no shape in particular.
struct Scene {
  static constexpr int blocks = 7, corners = 30;
  static constexpr int slots_of_set[] = {1, 4, 3, 2, 1};
  std::vector<double> corner, centroid, velocity, spin, rate;
  BlockRows rows;
  std::vector<double> damping, springs;
  std::vector<int> pairs, places;

  explicit Scene(Numbers& numbers) {
    const auto fill = [&](std::vector<double>& row, int count) {
      for (int i = 0; i < count; ++i)
        row.push_back(numbers.any());
      return row.data();
    };
    rows = {fill(corner, 2 * corners), fill(centroid, 2 * blocks),
            fill(velocity, 2 * blocks), fill(spin, blocks), fill(rate, 4 * blocks)};
    const int sets = static_cast<int>(std::size(slots_of_set));
    const int slots = std::accumulate(slots_of_set, slots_of_set + sets, 0);
    fill(damping, sets * lane_count);
    fill(springs, 2 * slots * lane_count);
    for (int i = 0; i < 2 * sets * lane_count; ++i)
      pairs.push_back(numbers.below(blocks));
    for (int i = 0; i < slots * lane_count; ++i)
      for (const int count : {corners, corners, corners, 3, 3, 2})
        places.push_back(numbers.below(count));
  }

  void put(ContactLanes& lanes) const {
    lanes.reserve({5, 11, 5, 11}, false);
    for (const int slots : slots_of_set)
      lanes.add_set(slots);
    for (int i = 0; i < lanes.sets() * lane_count; ++i) {
      lanes.at(i, &LanePairs::low) = pairs[2 * i];
      lanes.at(i, &LanePairs::high) = pairs[2 * i + 1];
      lanes.at(i, &LanePairs::damping) = std::abs(damping[i]);
    }
    for (int i = 0; i < lanes.slots() * lane_count; ++i) {
      const int* const p = &places[6 * i];
      lanes.at(i, &SlotPlaces::corner) = p[0], lanes.at(i, &SlotPlaces::edge) = p[1],
                  lanes.at(i, &SlotPlaces::edge_end) = p[2];
      lanes.set(i, &SlotPlaces::asked, p[3] == 1);
      lanes.set(i, &SlotPlaces::decided, p[3] == 2);
      lanes.set(i, &SlotPlaces::touches, p[4] > 0);
      lanes.set(i, &SlotPlaces::starts, p[4] == 2);
      lanes.set(i, &SlotPlaces::flips, p[5] == 1);
      lanes.at(i, &SlotSprings::normal_elastic) = std::abs(springs[2 * i]);
      lanes.at(i, &SlotSprings::shear_elastic) = springs[2 * i + 1];
    }
  }
};

/// The bits of all that the lanes hold; a NaN is a NaN, for its sign is not defined.
std::vector<std::uint64_t> bits(const ContactLanes& lanes, LaneExtremes extremes,
                                bool stresses, bool readings) {
  std::vector<std::uint64_t> found;
  const auto add = [&](const double& x) {
    std::uint64_t word;
    std::memcpy(&word, &x, sizeof word);
    found.push_back(std::isnan(x) ? 1 : word);
  };
  const auto add_row = [&](const auto& row) {
    for (const auto& x : row)
      add(x);
  };
  for (int set = 0; set < lanes.sets(); ++set) {
    found.push_back(lanes.pairs[set].look);
    for (int k = 0; k < lane_count; ++k) {
      const PairForce& of = lanes.forces[set * lane_count + k];
      add(of.fx), add(of.fy), add(of.moment_low), add(of.moment_high);
    }
    for (int k = 0; stresses && k < lane_count; ++k) {
      const PairStress& of = lanes.stresses[set * lane_count + k];
      add_row(of.low), add_row(of.high);
    }
  }
  for (int slot = 0; slot < lanes.slots(); ++slot) {
    found.push_back(lanes.places[slot].touches);
    found.push_back(lanes.places[slot].starts);
    add_row(lanes.advanced[slot].normal_elastic);
    add_row(lanes.advanced[slot].shear_elastic);
    if (!readings)
      continue;
    const SlotReadings& of = lanes.readings[slot];
    for (const auto* row : {&of.overlap, &of.normal_force, &of.shear_force})
      add_row(*row);
  }
  add(extremes.overlap);
  add(extremes.spring);
  return found;
}

struct Case {
  bool rigid, readings;
};
constexpr Case cases[] = {{true, false}, {true, true}, {false, false}, {false, true}};

TEST(ContactLanes, EveryInstructionSetGivesTheSameBits) {
  Numbers numbers;
  EXPECT_EQ(all_lane_arithmetic().front().name, "baseline");
  for (int trial = 0; trial < 500; ++trial) {
    const Scene scene(numbers);
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    for (const auto& [rigid, readings] : cases) {
      std::vector<std::uint64_t> expected;
      for (const LaneArithmetic& arithmetic : all_lane_arithmetic()) {
        ContactLanes lanes;
        scene.put(lanes);
        LaneExtremes extremes =
            arithmetic.touch_and_act(lanes, scene.rows, law, rigid, 0, lanes.sets());
        if (readings)
          extremes =
              arithmetic.act(lanes, scene.rows, law, rigid, true, 0, lanes.sets());
        const auto found = bits(lanes, extremes, !rigid || readings, readings);
        if (expected.empty())
          expected = found;
        ASSERT_EQ(found, expected) << arithmetic.name;
      }
    }
  }
}

// What touches, where it is not left open, is exact: whole coordinates make many ties,
// steps of a unit in the last place many that are nearly such.
TEST(ContactLanes, WhatTouchesIsDecidedExactly) {
  std::mt19937_64 random(5);
  const auto below = [&](int count) { return static_cast<int>(random() % count); };
  long ties = 0, open = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> corner(2 * Scene::corners);
    for (double& x : corner) {
      x = below(4) - 1;
      for (int k = trial % 4; k > 0; --k)
        x = std::nextafter(x, below(3) - 1);
      x = trial % 5 == 0 ? std::ldexp(x, -540) : x;
    }
    const double zeros[2] = {};
    const BlockRows rows{corner.data(), zeros, zeros, zeros, zeros};
    const auto at = [&](int c) { return Vec2(corner[2 * c], corner[2 * c + 1]); };
    ContactLanes lanes;
    lanes.reserve({1, 1}, true);
    lanes.add_set(1);
    SlotPlaces& slot = lanes.places[0];
    for (int k = 0; k < lane_count; ++k) {
      slot.corner[k] = below(Scene::corners), slot.edge[k] = below(Scene::corners);
      slot.edge_end[k] = below(Scene::corners);
      lanes.set(k, &SlotPlaces::asked, true);
    }
    lane_arithmetic().touch_and_act(lanes, rows, {1.0, 1.0, 1.0, 1.0}, true, 0, 1);
    for (int k = 0; k < lane_count; ++k) {
      const Vec2 c = at(slot.corner[k]), p1 = at(slot.edge[k]),
                 p2 = at(slot.edge_end[k]);
      const int sign = geometry::exact::overlap_sign(c, p1, p2);
      const bool acts = sign > 0 && geometry::exact::between(c, p1, p2);
      const bool touches = lanes.is(k, &SlotPlaces::touches);
      if (!touches || lanes.pairs[0].look == 0) {
        ASSERT_EQ(touches, acts) << trial;
      }
      ties += !touches && sign == 0;
      open += touches && !acts;
    }
  }
  EXPECT_GT(ties, 2000);
  EXPECT_GT(open, 100);
}

// Once more, now that it is known what touches, and with what readers want: the same.
TEST(ContactLanes, ReadingsDoNotChangeAStep) {
  Numbers numbers;
  for (int trial = 0; trial < 200; ++trial) {
    const Scene scene(numbers);
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    for (const bool rigid : {true, false}) {
      ContactLanes lanes;
      scene.put(lanes);
      const LaneArithmetic& arithmetic = lane_arithmetic();
      arithmetic.touch_and_act(lanes, scene.rows, law, rigid, 0, lanes.sets());
      const auto found = bits(lanes, {}, !rigid, false);
      for (const bool readings : {false, true}) {
        arithmetic.act(lanes, scene.rows, law, rigid, readings, 0, lanes.sets());
        ASSERT_EQ(bits(lanes, {}, !rigid, false), found);
      }
      // each set alone
      std::vector<double> all, alone;
      const auto add = [&](std::vector<double>& to, int slot, int from) {
        for (const double force : lanes.readings[slot - from].normal_force)
          to.push_back(force);
      };
      for (int slot = 0; slot < lanes.slots(); ++slot)
        add(all, slot, 0);
      for (int set = 0; set < lanes.sets(); ++set) {
        lanes.read_from(set, rigid);
        arithmetic.act(lanes, scene.rows, law, rigid, true, set, set + 1);
        const LanePairs& of = lanes.pairs[set];
        for (int slot = of.first_slot; slot < of.first_slot + of.slots; ++slot)
          add(alone, slot, of.first_slot);
      }
      ASSERT_EQ(std::memcmp(all.data(), alone.data(), all.size() * sizeof(double)), 0);
      ASSERT_EQ(all.size(), alone.size());
    }
  }
}

}  // namespace
}  // namespace blocks::dynamics
