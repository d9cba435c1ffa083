// The laws of joints give the same bits for one contact and for the lanes of vectors,
// and the law of JOINT those of contact_law.hpp if it has friction only.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/law_lanes/law_lanes.hpp"

namespace blocks::dynamics {
namespace {

constexpr double dt = 0x1.3p-12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random numbers of many magnitudes, and zeros.
class Random {
 public:
  double positive() {
    return below(8) == 0 ? 0.0 : std::ldexp(1.0 + uniform_(random_), below(40) - 20);
  }
  double any() { return below(2) == 0 ? positive() : -positive(); }
  double above_zero() { return std::ldexp(1.0 + uniform_(random_), below(40) - 20); }
  int below(int count) { return static_cast<int>(random_() % count); }

 private:
  std::mt19937_64 random_{33};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

using Law = LawValues<double>;
using Motion = ContactMotion<double>;
using State = ContactState<double>;
using Force = ContactForce<double>;

// A joint with friction only is FRICTN.
TEST(JointLawBits, FrictionOnlyIsTheLawOfTheReport) {
  Random random;
  long kept = 0, slid = 0, started = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const ContactLaw old = {random.above_zero(), random.positive(), random.positive(),
                            dt};
    Law law = {};
    law.friction = law.residual_friction = old.friction;
    law.dilation_limit = i % 2 == 0 ? infinity : random.positive();
    const Motion motion = {random.any(), random.any(), random.positive(),
                           random.positive(), 1.0 * (i % 3 > 0)};
    State state = {};
    state.normal = random.positive(), state.shear = random.any();
    state.stiffness = old.normal_stiffness, state.shear_stiffness = old.shear_stiffness;
    state.failed = random.below(2), state.length = random.positive();
    double normal = state.normal, shear = state.shear, fn, fs;
    Force force;
    if (i % 3 == 0 && i % 2 == 0) {
      apply<false>(old, normal, shear, motion.closing, motion.sliding, motion.overlap,
                   motion.damping, motion.starting, fn, fs);
      apply_coulomb<false>(law, dt, motion, state, force);
    } else {
      apply(old, normal, shear, motion.closing, motion.sliding, motion.overlap,
            motion.damping, motion.starting, fn, fs);
      apply_coulomb(law, dt, motion, state, force);
    }
    ASSERT_TRUE(same_bits(normal, state.normal) && same_bits(shear, state.shear) &&
                same_bits(fn, force.normal) && same_bits(fs, force.shear))
        << i;
    ASSERT_TRUE(same_bits(state.offset, 0.0) && state.bonded == 0.0);
    kept += normal > 0.0, slid += state.path > 0.0, started += motion.starting > 0.0;
  }
  EXPECT_GT(kept, 500'000);
  EXPECT_GT(slid, 300'000);
  EXPECT_GT(started, 1'000'000);
}

/// Eight random contacts of a law, of every size, in every state.
EightContacts random_contacts(Random& random) {
  EightContacts eight = {};
  for (int k = 0; k < 8; ++k) {
    const double vm = random.above_zero(), linear = random.below(4) * 0.3 * vm;
    const double law[] = {random.positive(),
                          random.positive(),
                          random.positive(),
                          random.positive(),
                          random.positive(),
                          random.positive(),
                          random.positive(),
                          random.below(3) == 0 ? infinity : random.positive(),
                          1.0 + random.positive(),
                          1.0 * random.below(21),
                          random.above_zero(),
                          random.below(70) * 0.0174,
                          random.above_zero(),
                          vm,
                          linear};
    const double motion[] = {random.any(), random.any(), random.positive(),
                             random.positive(), 1.0 * random.below(2)};
    const double state[] = {
        random.positive(),     random.any(),          random.above_zero(),
        random.positive(),     random.any(),          random.positive(),
        random.positive(),     random.positive(),     random.positive(),
        1.0 * random.below(2), 1.0 * random.below(2), random.positive()};
    for (std::size_t i = 0; i < std::size(law); ++i)
      eight.law[i][k] = law[i];
    for (std::size_t i = 0; i < std::size(motion); ++i)
      eight.motion[i][k] = motion[i];
    for (std::size_t i = 0; i < std::size(state); ++i)
      eight.state[i][k] = state[i];
  }
  return eight;
}

/// Returns whether two results have the same bits. The sign of a NaN is not defined.
bool same_results(const EightContacts& a, const EightContacts& b) {
  const auto same = [](const auto& one, const auto& other) {
    const double* const x = reinterpret_cast<const double*>(&one);
    const double* const y = reinterpret_cast<const double*>(&other);
    for (std::size_t i = 0; i < sizeof one / sizeof *x; ++i)
      if (!same_bits(x[i], y[i]) && !(std::isnan(x[i]) && std::isnan(y[i])))
        return false;
    return true;
  };
  return same(a.state, b.state) && same(a.force, b.force) && same(a.energy, b.energy);
}

TEST(JointLawBits, EveryInstructionSetGivesTheSame) {
  std::vector<AdvanceEight*> advances = {advance_baseline};
#ifdef BLOCKS_X86_KERNELS
  if (__builtin_cpu_supports("avx2"))
    advances.push_back(advance_avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    advances.push_back(advance_avx512);
#endif
  Random random;
  long finite = 0;
  for (int i = 0; i < 60'000; ++i) {
    const EightContacts start = random_contacts(random);
    EightContacts expected = start;
    advance_one_by_one(expected, i % 3, dt);
    for (AdvanceEight* const advance : advances) {
      EightContacts found = start;
      advance(found, i % 3, dt);
      ASSERT_TRUE(same_results(expected, found)) << i;
    }
    for (int k = 0; k < 8; ++k)
      finite += std::isfinite(expected.energy[k] + expected.force[0][k] +
                              expected.force[1][k] + expected.state[8][k]);
  }
  EXPECT_GT(finite, 470'000);
}

}  // namespace
}  // namespace blocks::dynamics
