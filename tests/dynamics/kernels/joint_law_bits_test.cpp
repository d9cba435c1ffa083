// The laws of joints give the same bits for one contact and for the lanes of vectors,
// and the law of JOINT those of FRICTN if it has friction only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/law_lanes/law_lanes.hpp"

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

/// Returns x limited to -limit and limit. The zeros keep their signs as in the laws.
double limited(double x, double limit) {
  const double below = x < limit ? x : limit;
  return below > -limit ? below : -limit;
}

/// The law of the report, (16)-(18), with the departures of the documentation, written
/// out for one contact.
void advance_by_report(const ContactLaw& law, const Motion& motion, double& normal,
                       double& shear, Force& force) {
  const double advance = motion.closing * law.dt;
  const bool starts = motion.starting > 0.0;
  const double share =
      starts && advance > motion.overlap ? motion.overlap / advance : 1.0;
  normal = std::max(0.0, normal + share * law.normal_stiffness * advance);
  if (starts)
    normal = std::min(normal, law.normal_stiffness * motion.overlap);
  force.normal = std::max(0.0, normal + motion.damping * motion.closing);
  const double limit = law.friction * force.normal;
  const double trial = shear + share * law.shear_stiffness * motion.sliding * law.dt;
  shear = limited(trial, limit);
  const double damped = limited(shear + motion.damping * motion.sliding, limit);
  force.shear = shear == trial ? damped : shear;
}

// A joint with friction only is FRICTN.
TEST(JointLawBits, FrictionOnlyIsTheLawOfTheReport) {
  Random random;
  long kept = 0, slid = 0, started = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const ContactLaw usual = {random.above_zero(), random.positive(), random.positive(),
                              dt};
    Law law = {};
    law.friction = law.residual_friction = usual.friction;
    law.dilation_limit = i % 2 == 0 ? infinity : random.positive();
    const bool may_start = i % 6 != 0;
    const Motion motion = {random.any(), random.any(), random.positive(),
                           random.positive(), 1.0 * (i % 3 > 0)};
    double normal = random.positive(), shear = random.any();
    State state = usual_state(usual, normal, shear), plain = state;
    state.failed = random.below(2), state.length = random.positive();
    Force printed, force, of_plain;
    advance_by_report(usual, motion, normal, shear, printed);
    if (may_start)
      apply_coulomb<true>(law, dt, motion, state, force),
          apply_usual<true>(usual, motion, plain, of_plain);
    else
      apply_coulomb<false>(law, dt, motion, state, force),
          apply_usual<false>(usual, motion, plain, of_plain);
    for (const auto& [now, of] : {std::pair(state, force), std::pair(plain, of_plain)})
      ASSERT_TRUE(same_bits(normal, now.normal) && same_bits(shear, now.shear) &&
                  same_bits(printed.normal, of.normal) &&
                  same_bits(printed.shear, of.shear))
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
    const LawBits law = 1U << i % 3;
    advance_one_by_one(expected, law, dt);
    for (AdvanceEight* const advance : advances) {
      EightContacts found = start;
      advance(found, law, dt);
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
