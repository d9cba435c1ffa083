// Motion under the contact law agrees with analytic solutions
// (docs/theory.md#the-force-in-its-order).
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/kernels/contact_law.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

// The floor is wider than the block, so two contacts carry the weight and the overlap
// is W / (2 Kn).
TEST(RestingBlock, OverlapsByItsWeightOverTwiceTheStiffness) {
  Scene scene;
  scene.box(-5, -1, 10, 1, true);
  const int b = scene.box(0, 0, 1, 1);
  scene.gravity(0, -10);
  scene.model.settings.damping = 0.3;
  scene.run(2.0);
  const double overlap = scene.weight(b) / (2 * scene.model.settings.normal_stiffness);
  EXPECT_NEAR(0.5 - scene.centroid(b).y(), overlap, 1e-9 * overlap + 1e-15);
  EXPECT_LT(totals(scene.model).kinetic_energy, 1e-18);
}

/// Returns the restitution of a spring and dashpot without tension, in closed form. A
/// flush face has two contacts, so its damping ratio is z = b sqrt 2.
double restitution(double z) {
  const double q = std::sqrt(1 - z * z);
  return std::exp(-z / q * (M_PI - std::atan2(2 * z * q, 1 - 2 * z * z)));
}

TEST(Bounce, HasTheAnalyticRestitution) {
  const double expected[] = {0.808, 0.469, 0.208};
  const double damping[] = {0.05, 0.2, 0.5};
  for (int i = 0; i < 3; ++i) {
    Scene scene;
    scene.box(-5, -1, 10, 1, true);
    const int b = scene.box(0, 0.01, 1, 1);
    scene.velocity(b, 0, -1);
    scene.model.settings.damping = damping[i];
    scene.model.settings.fraction = 0.001;
    scene.run(0.1);
    const double e = scene.velocity(b).y();
    EXPECT_NEAR(e, restitution(damping[i] * std::sqrt(2.0)), 0.002) << damping[i];
    EXPECT_NEAR(e, expected[i], 0.003) << damping[i];
  }
}

// With the old velocity in (3) the block would bounce with 1.25 times its speed.
TEST(Bounce, KeepsTheSpeedWithoutDamping) {
  Scene scene;
  scene.box(-5, -1, 10, 1, true);
  const int b = scene.box(0, 0.01, 1, 1);
  scene.velocity(b, 0, -1);
  scene.model.settings.fraction = 0.01;
  scene.run(0.1);
  EXPECT_NEAR(scene.velocity(b).y(), 1.0, 0.002);
}

// A sliding block has a = g (sin psi - mu cos psi). It sticks if mu > tan psi.
TEST(Incline, BlockSlidesOrSticksByTheCoulombLimit) {
  const double psi = 30 * M_PI / 180;
  for (const double mu : {0.3, 0.6}) {
    Scene scene(Frame{-psi, {3, 4}});
    scene.box(-2, -1, 50, 1, true);
    const int b = scene.box(0, 0, 2, 1);
    scene.gravity(10 * std::sin(psi), -10 * std::cos(psi));
    scene.model.settings.friction = mu;
    scene.model.settings.damping = 0.5;
    scene.run(1.0);  // The block settles.
    const double v0 = scene.velocity(b).x(), t0 = scene.model.time;
    scene.run(1.0);
    const double a = (scene.velocity(b).x() - v0) / (scene.model.time - t0);
    const double expected =
        mu > std::tan(psi) ? 0.0 : 10 * (std::sin(psi) - mu * std::cos(psi));
    EXPECT_NEAR(a, expected, 1e-6) << mu;
  }
}

// Friction decelerates the block by mu g in either direction until it stops.
TEST(Friction, DeceleratesInBothDirectionsAlike) {
  double stopped[2];
  for (const int way : {0, 1}) {
    Scene scene;
    scene.box(-50, -1, 100, 1, true);
    const int b = scene.box(-1, 0, 2, 1);
    scene.gravity(0, -10);
    scene.model.settings.friction = 0.5;
    scene.model.settings.damping = 0.5;
    scene.run(0.5);
    const double x0 = scene.centroid(b).x();
    scene.velocity(b, way == 0 ? 2.0 : -2.0, 0);
    scene.run(0.3);
    EXPECT_NEAR(std::abs(scene.velocity(b).x()), 2.0 - 0.5 * 10 * 0.3, 0.01);
    scene.run(0.7);
    EXPECT_LT(scene.velocity(b).norm(), 1e-9);
    stopped[way] = scene.centroid(b).x() - x0;
    EXPECT_NEAR(std::abs(stopped[way]), 4.0 / (2 * 0.5 * 10), 0.01);
  }
  EXPECT_NEAR(stopped[0], -stopped[1], 1e-6);
}

// The forces of a contact are equal and opposite and act at one point.
TEST(Impact, KeepsLinearAndAngularMomentum) {
  Scene scene;
  const int a = scene.box(0, 0, 1, 1);
  const int b = scene.add({{1.05, 0.6}, {1.3, 1.5}, {2.2, 1.3}, {2.0, 0.4}});
  scene.velocity(a, 3, 0.5, 1.0);
  scene.velocity(b, -2, -0.3, -0.5);
  scene.model.settings.friction = 0.4;
  scene.model.settings.damping = 0.2;
  const ModelTotals before = totals(scene.model);
  bool touched = false;
  scene.prepare();
  while (scene.model.time < 0.2) {
    scene.step();
    touched = touched || totals(scene.model).active_contacts > 0;
  }
  const ModelTotals after = totals(scene.model);
  ASSERT_TRUE(touched);
  const double mass = scene.model.blocks.mass.sum();
  EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-12 * mass * 3);
  EXPECT_NEAR(after.angular_momentum, before.angular_momentum, 1e-11 * mass * 3);
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
  EXPECT_NE(scene.model.blocks.spin[a], 1.0);
}

/// Springs and forces of one contact.
struct OneContact {
  double normal_elastic = 0.0, shear_elastic = 0.0, normal = 0.0, shear = 0.0;
  void apply(const dynamics::ContactLaw& law, double closing, double sliding,
             double overlap, double damping, bool starting) {
    auto state = dynamics::usual_state(law, normal_elastic, shear_elastic);
    dynamics::ContactForce<double> force;
    dynamics::apply_usual(
        law, {closing, sliding, overlap, damping, starting ? 1.0 : 0.0}, state, force);
    normal_elastic = state.normal, shear_elastic = state.shear;
    normal = force.normal, shear = force.shear;
  }
};

TEST(ContactLaw, DashpotNeverPulls) {
  const dynamics::ContactLaw law{1e6, 1e6, 0.5, 1e-4};
  OneContact opening{10.0, 0.0};
  opening.apply(law, -1.0, 0.3, 1e-3, 1e3, false);
  EXPECT_EQ(opening.normal, 0.0);
  EXPECT_EQ(opening.shear, 0.0);
}

TEST(ContactLaw, FrictionNeverExceedsTheCoulombLimit) {
  const dynamics::ContactLaw law{1e6, 1e6, 0.5, 1e-4};
  OneContact sliding{10.0, 4.9};
  sliding.apply(law, 0.0, 1.0, 1e-3, 0.0, false);
  EXPECT_EQ(sliding.shear, 5.0);
  EXPECT_EQ(sliding.shear_elastic, 5.0);
}

TEST(ContactLaw, FirstStepCompressesTheSpringByTheOverlapOnly) {
  const dynamics::ContactLaw law{1e6, 1e6, 0.5, 1e-3};
  OneContact contact;
  contact.apply(law, 2.0, 0.5, 1e-3, 0.0, true);
  EXPECT_DOUBLE_EQ(contact.normal, 1e6 * 1e-3);
  EXPECT_DOUBLE_EQ(contact.shear, 0.5 * 1e6 * 0.5e-3);
}

// Two boxes that meet face to face close 4 contacts. One box closes 2 contacts with the
// plane, half as fast. So the half model has 4 Kn and sqrt(2) b.
TEST(SymmetryPlane, MakesAHalfModelMoveLikeTheFullModel) {
  Scene full, half;
  full.model.settings.damping = 0.2;
  half.model.settings.damping = 0.2 * std::sqrt(2.0);
  half.model.settings.normal_stiffness = half.model.settings.shear_stiffness = 4e7;
  half.model.settings.fraction =
      2 * full.model.settings.fraction;  // Both models have the same time step.
  const int left = full.box(-2.02, 0, 2, 1), right = full.box(0.02, 0, 2, 1);
  const int only = half.box(0.02, 0, 2, 1);
  half.plane({0, 10}, {0, 0});
  full.velocity(left, 1, 0.5);
  full.velocity(right, -1, 0.5);
  half.velocity(only, -1, 0.5);
  full.run(0.2);
  half.run(0.2);
  ASSERT_EQ(full.dt(), half.dt());
  EXPECT_GT(half.velocity(only).x(), 0.3);  // The box has bounced.
  EXPECT_NEAR(full.centroid(right).x(), half.centroid(only).x(), 1e-9);
  EXPECT_NEAR(full.velocity(right).x(), half.velocity(only).x(), 1e-9);
  EXPECT_NEAR(full.centroid(left).x(), -half.centroid(only).x(), 1e-9);
  EXPECT_NEAR(full.centroid(right).y(), half.centroid(only).y(), 1e-12);
}

}  // namespace
}  // namespace blocks
