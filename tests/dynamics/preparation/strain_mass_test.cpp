// The effective mass of strain rates is a tensor that turns with the block
// (docs/theory.md#strain-rates-and-stress), so deformable blocks do not feel the axes.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "dynamics/energy/block_energy.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

const std::vector<geometry::Polygon> outlines = {
    {{0, 0}, {0, 1}, {3, 1}, {3, 0}},                          // a beam
    {{0, 0}, {0.2, 1}, {2, 0.3}},                              // a sharp triangle
    {{0, 0}, {0, 1}, {1, 1.5}, {2, 0.4}, {1.2, -0.5}},         // a cell
    {{0, 0}, {0, 2}, {0.5, 2}, {0.5, 0.5}, {3, 0.5}, {3, 0}},  // an angle
    {{0, 0}, {0, 1e-3}, {1, 1e-3}, {1, 0}}};                   // a needle

Eigen::Matrix2d tensor(const Eigen::Vector4d& rows) {
  return (Eigen::Matrix2d() << rows[0], rows[1], rows[2], rows[3]).finished();
}
Eigen::Vector4d rows(const Eigen::Matrix2d& t) {
  return {t(0, 0), t(0, 1), t(1, 0), t(1, 1)};
}
Eigen::Matrix2d rotation(const Frame& frame) {
  Eigen::Matrix2d r;
  r.col(0) = frame.turn({1, 0}), r.col(1) = frame.turn({0, 1});
  return r;
}

/// What damps the free vibration of a block.
struct Damping {
  double local, vibration;
};

/// Lets a block with this stress and spin vibrate freely. Returns its stress, turned
/// back into the frame of the scene, after `steps` steps.
Eigen::Matrix2d stress_after(const Frame& frame, const geometry::Polygon& outline,
                             double spin, Damping damping, int steps) {
  Scene scene(frame);
  scene.model.settings.rigid = false;
  scene.model.settings.local_damping = damping.local;
  scene.model.settings.materials.at(1).damping = damping.vibration;
  const int b = scene.add(outline);
  scene.velocity(b, 0, 0, spin);
  scene.prepare();
  const Eigen::Matrix2d r = rotation(frame);
  const Eigen::Matrix2d start = (Eigen::Matrix2d() << -1e6, 3e5, 3e5, 4e5).finished();
  scene.model.blocks.stress.col(b) = rows(r * start * r.transpose());
  for (int i = 0; i < steps; ++i)
    scene.step();
  return r.transpose() * tensor(scene.model.blocks.stress.col(b)) * r;
}

TEST(StrainMass, FreeVibrationIsTheSameInEveryFrame) {
  const Damping dampings[] = {{0, 0}, {0, 0.2}, {0.3, 0}, {0.3, 0.2}};
  for (const geometry::Polygon& outline : outlines)
    for (const Damping& damping : dampings)
      for (const double spin : {0.0, 40.0}) {
        const Eigen::Matrix2d expected = stress_after({}, outline, spin, damping, 30);
        EXPECT_GT(expected.norm(), 1.0);
        for (const double degrees : {17.2, 45.0, 73.0, 90.0, 200.0}) {
          const Frame frame{degrees * 3.14159265358979 / 180, {30, -7}};
          const Eigen::Matrix2d found = stress_after(frame, outline, spin, damping, 30);
          // The moments of the needle differ by a factor of 1e6.
          EXPECT_LE((found - expected).norm(), 1e-7 * 1e6)
              << degrees << ' ' << outline.size() << ' ' << spin;
        }
      }
}

// (11): l_j^2 M / 4A along both sides of a rectangle, and the mean for the shear.
TEST(StrainMass, IsThatOfTheReportForRectangles) {
  for (const double degrees : {0.0, 30.0, 45.0}) {
    const Frame frame{degrees * 3.14159265358979 / 180};
    const Eigen::Matrix2d r = rotation(frame);
    Scene scene(frame);
    scene.model.settings.rigid = false;
    const int b = scene.box(0, 0, 3, 0.5);
    scene.prepare();
    Blocks& blocks = scene.model.blocks;
    const Eigen::Matrix2d stress =
        (Eigen::Matrix2d() << 1e6, 2e5, 2e5, -4e5).finished();
    blocks.stress.col(b) = rows(r * stress * r.transpose());
    scene.step();
    const Eigen::Matrix2d rate =
        r.transpose() * tensor(blocks.strain_rate.col(b)) * r / scene.dt();
    const double density = 2000.0, m11 = density * 9 / 4, m22 = density * 0.25 / 4;
    EXPECT_NEAR(rate(0, 0), -1e6 / m11, 1e-9 * 1e6 / m11);
    EXPECT_NEAR(rate(1, 1), 4e5 / m22, 1e-9 * 4e5 / m22);
    EXPECT_NEAR(rate(0, 1), -2e5 / (0.5 * (m11 + m22)), 1e-9 * 2e5 / m22);
  }
}

// Vibration is stable up to omega dt = 2; half of omega^2 dt^2 is left to contacts.
TEST(StrainMass, TheTimeStepLeavesHalfOfTheBoundToContacts) {
  for (const geometry::Polygon& outline : outlines)
    for (const double degrees : {0.0, 25.0}) {
      Scene scene(Frame{degrees * 3.14159265358979 / 180});
      scene.model.settings.rigid = false;
      scene.model.settings.normal_stiffness = scene.model.settings.shear_stiffness = 1;
      const int b = scene.add(outline);
      scene.prepare();
      ASSERT_TRUE(scene.model.time_step.elastic);
      const Material& material = scene.model.settings.materials.at(1);
      const auto [m11, m22, m12] =
          dynamics::masses_of(scene.model.blocks, b, false).strain;
      Eigen::Matrix3d mass, stiffness;
      mass << m11, 0, m12, 0, m22, m12, m12, m12, m11 + m22;
      stiffness << material.c11(), material.c12(), 0, material.c12(), material.c11(), 0,
          0, 0, 4 * material.shear_modulus;
      stiffness *= scene.model.blocks.area[b];
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solved(stiffness,
                                                                             mass);
      const double square = solved.eigenvalues().maxCoeff() * scene.dt() * scene.dt();
      EXPECT_LE(square, 2.0);
      EXPECT_GE(square, 0.5);
    }
}

// A block that turns keeps the energy of its strain rates.
TEST(StrainMass, TurnsWithTheBlock) {
  for (const geometry::Polygon& outline : outlines) {
    Scene scene;
    scene.model.settings.rigid = false;
    scene.model.settings.materials.at(1) = {1e-3, 4e-4, 2000.0};
    scene.model.settings.normal_stiffness = scene.model.settings.shear_stiffness = 1e3;
    const int b = scene.add(outline);
    scene.velocity(b, 0, 0, 2.0);
    scene.prepare();
    Blocks& blocks = scene.model.blocks;
    blocks.strain_rate.col(b) << 1e-9, 3e-10, 3e-10, -5e-10;
    const auto energy = [&] {
      dynamics::BlockMotion motion = dynamics::motion_of(blocks, b);
      motion.spin = 0;
      return dynamics::kinetic_energy(dynamics::masses_of(blocks, b, false), motion,
                                      motion);
    };
    const double before = energy();
    while (blocks.angle[b] < 1.3)
      scene.step();
    EXPECT_NEAR(energy() / before, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace blocks
