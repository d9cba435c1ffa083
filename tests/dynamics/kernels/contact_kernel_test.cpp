// The contact kernel gives the same bits with every instruction set.
#include "dynamics/contacts/contact_batches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <numeric>
#include <random>

#include "dynamics/kernels/kernels.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

using geometry::Vec2;

/// Random numbers of every magnitude and both signs, and zeros.
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

/// Random contacts between random corners and blocks.
struct Scene {
  static constexpr int blocks = 7, corners = 30;
  static constexpr int rows_of_batch[] = {1, 4, 3, 2, 1};
  std::vector<double> corner, centroid, velocity, spin, rate;
  BlockState state;
  std::vector<double> damping, springs;
  std::vector<int> pairs, contacts;

  explicit Scene(Numbers& numbers) {
    const auto fill = [&](std::vector<double>& row, int count) {
      for (int i = 0; i < count; ++i)
        row.push_back(numbers.any());
      return row.data();
    };
    state = {fill(corner, 2 * corners), fill(centroid, 2 * blocks),
             fill(velocity, 2 * blocks), fill(spin, blocks), fill(rate, 4 * blocks)};
    const int batches = static_cast<int>(std::size(rows_of_batch));
    const int rows = std::accumulate(rows_of_batch, rows_of_batch + batches, 0);
    fill(damping, batches * lane_count);
    fill(springs, 2 * rows * lane_count);
    for (int i = 0; i < 2 * batches * lane_count; ++i)
      pairs.push_back(numbers.below(blocks));
    for (int i = 0; i < rows * lane_count; ++i)
      for (const int count : {corners, corners, corners, 3, 3, 2})
        contacts.push_back(numbers.below(count));
  }

  /// Fills the batches with the contacts of the scene.
  void put(ContactBatches& batches) const {
    batches.reserve(5, 11, false);
    for (const int rows : rows_of_batch)
      batches.add_batch(rows);
    for (int i = 0; i < batches.batches() * lane_count; ++i) {
      batches.at(i, &BatchPairs::low) = pairs[2 * i];
      batches.at(i, &BatchPairs::high) = pairs[2 * i + 1];
      batches.at(i, &BatchPairs::damping) = std::abs(damping[i]);
    }
    for (int i = 0; i < batches.rows() * lane_count; ++i) {
      const int* const p = &contacts[6 * i];
      batches.at(i, &ContactRow::corner) = p[0],
                    batches.at(i, &ContactRow::edge) = p[1],
                    batches.at(i, &ContactRow::edge_end) = p[2];
      batches.set(i, &ContactTests::tested, p[3] == 1);
      batches.set(i, &ContactTests::certain, p[3] == 2);
      batches.set(i, &ContactStates::acts, p[4] > 0);
      batches.set(i, &ContactStates::starts, p[4] == 2);
      batches.set(i, &ContactTests::edge_is_low, p[5] == 1);
      batches.at(i, &SpringRow::normal_elastic) = std::abs(springs[2 * i]);
      batches.at(i, &SpringRow::shear_elastic) = springs[2 * i + 1];
    }
  }
};

/// Returns the bits of all results in the batches. All NaNs are the same, because the
/// sign of a NaN is not defined.
std::vector<std::uint64_t> bits(const ContactBatches& batches, Extremes extremes,
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
  for (int batch = 0; batch < batches.batches(); ++batch) {
    found.push_back(batches.marks[batch].ends);
    found.push_back(batches.marks[batch].unsettled);
    for (int k = 0; k < lane_count; ++k) {
      const PairForce& of = batches.forces[batch * lane_count + k];
      add(of.fx), add(of.fy), add(of.moment_low), add(of.moment_high);
    }
    for (int k = 0; stresses && k < lane_count; ++k) {
      const PairStress& of = batches.stresses[batch * lane_count + k];
      add_row(of.low), add_row(of.high);
    }
  }
  for (int row = 0; row < batches.rows(); ++row) {
    found.push_back(batches.states[row].acts);
    found.push_back(batches.states[row].starts);
    found.push_back(batches.states[row].ends);
    found.push_back(batches.states[row].in_doubt);
    add_row(batches.advanced[row].normal_elastic);
    add_row(batches.advanced[row].shear_elastic);
    if (!readings)
      continue;
    const ReadingRow& of = batches.readings[row];
    for (const auto* values : {&of.overlap, &of.normal_force, &of.shear_force})
      add_row(*values);
  }
  add(extremes.overlap);
  add(extremes.spring);
  return found;
}

struct Case {
  bool rigid, readings;
};
constexpr Case cases[] = {{true, false}, {true, true}, {false, false}, {false, true}};

TEST(ContactKernel, GivesTheSameBitsWithEveryInstructionSet) {
  Numbers numbers;
  EXPECT_EQ(all_kernels().front().name, "baseline");
  for (int trial = 0; trial < 500; ++trial) {
    const Scene scene(numbers);
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    for (const auto& [rigid, readings] : cases) {
      std::vector<std::uint64_t> expected;
      for (const Kernels& arithmetic : all_kernels()) {
        ContactBatches batches;
        scene.put(batches);
        Extremes extremes = arithmetic.test_and_compute_forces(
            batches, scene.state, law, rigid, 0, batches.batches());
        if (readings)
          extremes = arithmetic.compute_forces(batches, scene.state, law, rigid, true,
                                               0, batches.batches());
        const auto found = bits(batches, extremes, !rigid || readings, readings);
        if (expected.empty())
          expected = found;
        ASSERT_EQ(found, expected) << arithmetic.name;
      }
    }
  }
}

// Whole coordinates make many ties. Steps of one unit in the last place make many near
// ties, which the kernel may leave in doubt.
TEST(ContactKernel, DecidesWhatTouchesExactly) {
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
    const BlockState state{corner.data(), zeros, zeros, zeros, zeros};
    const auto at = [&](int c) { return Vec2(corner[2 * c], corner[2 * c + 1]); };
    ContactBatches batches;
    batches.reserve(1, 1, false);
    batches.add_batch(1);
    ContactRow& row = batches.contacts[0];
    for (int k = 0; k < lane_count; ++k) {
      row.corner[k] = below(Scene::corners), row.edge[k] = below(Scene::corners);
      row.edge_end[k] = below(Scene::corners);
      batches.set(k, &ContactTests::tested, true);
    }
    kernels().test_and_compute_forces(batches, state, {1.0, 1.0, 1.0, 1.0}, true, 0, 1);
    for (int k = 0; k < lane_count; ++k) {
      const Vec2 c = at(row.corner[k]), p1 = at(row.edge[k]), p2 = at(row.edge_end[k]);
      const int sign = geometry::exact::overlap_sign(c, p1, p2);
      const bool acts = sign > 0 && geometry::exact::between(c, p1, p2);
      const bool found = batches.is(k, &ContactStates::acts);
      if (!batches.is(k, &ContactStates::in_doubt)) {
        ASSERT_EQ(found, acts) << trial;
      }
      ties += !found && sign == 0;
      open += found && !acts;
    }
  }
  EXPECT_GT(ties, 2000);
  EXPECT_GT(open, 100);
}

// The kernel runs a second time with the known states, with and without readings.
TEST(ContactKernel, GivesTheSameForcesWithAndWithoutReadings) {
  Numbers numbers;
  for (int trial = 0; trial < 200; ++trial) {
    const Scene scene(numbers);
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    for (const bool rigid : {true, false}) {
      ContactBatches batches;
      scene.put(batches);
      const Kernels& arithmetic = kernels();
      arithmetic.test_and_compute_forces(batches, scene.state, law, rigid, 0,
                                         batches.batches());
      const auto found = bits(batches, {}, !rigid, false);
      for (const bool readings : {false, true}) {
        arithmetic.compute_forces(batches, scene.state, law, rigid, readings, 0,
                                  batches.batches());
        ASSERT_EQ(bits(batches, {}, !rigid, false), found);
      }
    }
  }
}

}  // namespace
}  // namespace blocks::dynamics
