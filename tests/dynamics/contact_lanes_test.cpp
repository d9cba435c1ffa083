// Every instruction set gives the same bits.
#include "dynamics/contact_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace blocks::dynamics {
namespace {

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
  static constexpr int sets = 5, size = sets * lane_count - 3, blocks = 7, corners = 30;
  std::vector<double> corner, arm, centroid, velocity, spin, rate;
  BlockRows rows;
  std::vector<double> springs;
  std::vector<int> places;

  explicit Scene(Numbers& numbers) {
    const auto fill = [&](std::vector<double>& row, int count) {
      for (int i = 0; i < count; ++i)
        row.push_back(numbers.any());
      return row.data();
    };
    rows = {fill(corner, 2 * corners),  fill(arm, 2 * corners),
            fill(centroid, 2 * blocks), fill(velocity, 2 * blocks),
            fill(spin, blocks),         fill(rate, 4 * blocks)};
    fill(springs, 3 * size);
    for (int i = 0; i < size; ++i)
      for (const int count : {corners, corners, corners, blocks, blocks, 3, 3})
        places.push_back(numbers.below(count));
  }

  void put(ContactLanes& lanes) const {
    lanes.resize(size);
    for (int i = 0; i < size; ++i) {
      const int* const p = &places[7 * i];
      lanes.at(i, &LanePlaces::corner) = p[0], lanes.at(i, &LanePlaces::edge) = p[1],
                  lanes.at(i, &LanePlaces::edge_end) = p[2];
      lanes.at(i, &LanePlaces::corner_block) = p[3],
                  lanes.at(i, &LanePlaces::edge_block) = p[4];
      lanes.at(i, &LanePlaces::rule) = p[5], lanes.at(i, &LanePlaces::touch) = p[6];
      lanes.at(i, &LaneSprings::normal_elastic) = std::abs(springs[3 * i]);
      lanes.at(i, &LaneSprings::shear_elastic) = springs[3 * i + 1];
      lanes.at(i, &LaneSprings::damping) = std::abs(springs[3 * i + 2]);
    }
  }
};

/// The bits of all that the lanes hold.
std::vector<std::uint64_t> bits(const ContactLanes& lanes, LaneExtremes extremes) {
  std::vector<std::uint64_t> found;
  for (int set = 0; set < lanes.sets(); ++set)
    found.push_back(lanes.places[set].look);
  const auto add = [&](const double& x) {
    std::uint64_t word;
    std::memcpy(&word, &x, sizeof word);
    found.push_back(std::isnan(x) ? 1 : word);  // of NaN the sign is not defined
  };
  for (int i = 0; i < Scene::size; ++i) {
    const auto add_rows = [&](auto... row) { (add(lanes.at(i, row)), ...); };
    add_rows(&LanePlaces::touch, &LaneSprings::normal_elastic,
             &LaneSprings::shear_elastic, &LaneForces::fx, &LaneForces::fy,
             &LaneForces::moment_low, &LaneForces::moment_high, &LaneReadings::low_x,
             &LaneReadings::low_y, &LaneReadings::high_x, &LaneReadings::high_y,
             &LaneReadings::overlap, &LaneReadings::normal_force,
             &LaneReadings::shear_force);
  }
  add(extremes.overlap);
  add(extremes.spring);
  return found;
}

TEST(ContactLanes, EveryInstructionSetGivesTheSameBits) {
  Numbers numbers;
  EXPECT_EQ(all_lane_arithmetic().front().name, "baseline");
  for (int trial = 0; trial < 500; ++trial) {
    const Scene scene(numbers);
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    for (const bool rigid : {true, false}) {
      std::vector<std::uint64_t> expected;
      for (const LaneArithmetic& arithmetic : all_lane_arithmetic()) {
        ContactLanes lanes;
        scene.put(lanes);
        arithmetic.find_touching(lanes, scene.rows, 0, lanes.sets());
        const LaneExtremes extremes =
            arithmetic.act(lanes, scene.rows, law, rigid, 0, lanes.sets());
        if (expected.empty())
          expected = bits(lanes, extremes);
        ASSERT_EQ(bits(lanes, extremes), expected) << arithmetic.name;
      }
    }
  }
}

}  // namespace
}  // namespace blocks::dynamics
