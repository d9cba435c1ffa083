// Elastic energy and losses of the laws of joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dynamics/expect_close.hpp"
#include "validation/laws/one_contact.hpp"

namespace blocks::validation {
namespace {

/// Random smooth motion that loads, opens, slides and reverses.
struct RandomPath {
  explicit RandomPath(unsigned seed) : random(seed) {
    for (double& x : phase)
      x = 2.0 * std::numbers::pi * uniform();
    for (double& x : frequency)
      x = 0.5 + 4.0 * uniform();
  }
  double uniform() { return std::uniform_real_distribution<double>()(random); }
  double closing(double t) const {
    return 0.08 * mm *
               (std::sin(frequency[0] * t) + std::sin(frequency[1] * t + phase[0])) +
           0.03 * mm * t;
  }
  double sliding(double t) const {
    return 3 * mm *
           (std::sin(frequency[2] * t) + std::sin(frequency[3] * t + phase[1]));
  }
  std::mt19937 random;
  double phase[2], frequency[4];
};

// A law may take energy, but the work done on a contact is never less than what its
// springs have gained.
TEST(JointLawEnergy, NoLawGivesEnergyThatItHasNotGot) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const RandomPath path(seed);
    OneContact contact = seed % 3 == 0   ? bonded_joint(0.0)
                         : seed % 3 == 1 ? OneContact(Kind::walton, 10 * GPa, 5 * GPa)
                                         : rough_joint(20 * GPa);
    contact.law.unloading_ratio = 3.0;
    if (seed % 3 == 0) {
      contact.law.dilation = std::tan(8 * degree), contact.law.dilation_limit = 2 * mm;
      contact.law.tension = 0.3 * MPa, contact.law.residual_tension = 0.1 * MPa;
    } else if (seed % 3 == 1) {
      contact.law.residual_friction = 0.6;
    }
    double work = 0.0, turnover = 0.0, min = 0.0;
    constexpr int steps = 200'000;
    for (int i = 0; i < steps; ++i) {
      const double t = 4.0 * i / steps, next = 4.0 * (i + 1) / steps;
      const double closing = path.closing(next) - path.closing(t);
      const double sliding = path.sliding(next) - path.sliding(t);
      const double normal = contact.state.normal, shear = contact.state.shear;
      contact.move(closing, sliding);
      const double part = 0.5 * (normal + contact.force.normal) * closing +
                          0.5 * (shear + contact.force.shear) * sliding;
      work += part, turnover += std::abs(part);
      min = std::min(min, work - contact.energy());
    }
    EXPECT_GT(turnover, 100.0) << seed;
    EXPECT_GT(min, -2e-5 * turnover) << seed;
    EXPECT_GT(work - contact.energy(), 2e-3 * turnover) << seed;
  }
}

TEST(JointLawEnergy, WaltonKeepsTheSquareOfTheRestitution) {
  OneContact contact(Kind::walton, 2e8, 0.0);
  contact.law.unloading_ratio = 1.0 / (0.7 * 0.7);
  contact.move(3 * mm, 0.0);
  EXPECT_CLOSE(contact.energy(), 0.7 * 0.7 * 0.5 * 2e8 * (3 * mm) * (3 * mm), 1e-14);
}

// The closure of Bandis is elastic: its energy is the work, and all of it comes back.
TEST(JointLawEnergy, BandisEnergyIsTheWork) {
  OneContact contact = rough_joint(1e10);
  double work = 0.0;
  for (const int steps : {1000, 50'000, 200'000}) {
    for (int i = 0; i < steps; ++i) {
      const double before = contact.force.normal;
      contact.move(1e-6 * mm, 0.0);
      work += 0.5 * (before + contact.force.normal) * 1e-6 * mm;
    }
    EXPECT_CLOSE(contact.energy(), work, 1e-6);
  }
}

}  // namespace
}  // namespace blocks::validation
