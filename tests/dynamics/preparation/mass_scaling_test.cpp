// MSCALE: scaled inertial masses have one critical step; weights stay.
#include "dynamics/preparation/mass_scaling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/energy/block_energy.hpp"
#include "dynamics/preparation/packed_contacts.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "dynamics/step.hpp"
#include "dynamics/workspace.hpp"
#include "model/safe_fraction.hpp"
#include "tools/rectangle.hpp"

namespace blocks::dynamics {
namespace {

using testing::rectangle;

/// A slab that carries ten small squares, and a fixed block.
Model graded(bool rigid = true) {
  Model model;
  Settings& settings = model.settings;
  settings.rigid = rigid;
  settings.mass_scaling = true;
  settings.lower = {-100, -100}, settings.upper = {100, 100};
  settings.contact_tolerance = 0.01;
  settings.fraction = 0.1;
  settings.materials[0] = {1e9, 4e8, 1.0};
  settings.gravity = {0.0, -10.0};
  model.blocks.append({rectangle(0, 0, 10, 5)});
  for (int i = 0; i < 10; ++i)
    model.blocks.append({rectangle(i, 5, 1, 1)});
  NewBlock fixed = rectangle(-50, -50, 1, 1);
  fixed.fixity = Fixity::by_user;
  model.blocks.append({fixed});
  for (int b = 0; b < model.blocks.size(); ++b) {
    model.blocks.velocity.col(b) = Vec2(1.0, 2.0 * b);
    model.blocks.spin[b] = 0.5;
  }
  return model;
}

double kinetic(const Model& model, int b) {
  const BlockMotion motion = motion_of(model.blocks, b);
  return kinetic_energy(masses_of(model.blocks, b, model.settings.rigid), motion,
                        motion);
}

// Each corner of a block counts twice, and the corners of neighbours near it count. The
// slab has 28 contacts. They are all on its upper side or at its corners, so it turns
// less easily than a rectangle with as many at its corners.
TEST(MassScaling, CountsTheContactsThatABlockMayHave) {
  const Model model = graded();
  const Eigen::VectorXd counts = packed_contacts(model.blocks, 0.01);
  const double count = 28.0, arms = 50.0, squares = 10.0 * 31.25 + 232.5,
               radius = 125.0 / 12.0;  // of gyration, squared
  const double middle = 0.5 * (count + squares / radius),
               half = 0.5 * (count - squares / radius);
  EXPECT_NEAR(counts[0], (middle + std::sqrt(half * half + arms * arms / radius)) / 3.0,
              1e-12);
  for (int b = 2; b <= 9; ++b)  // 8, and those of the neighbours on both sides
    EXPECT_NEAR(counts[b], 12.0, 1e-12);
  EXPECT_EQ(counts[11], 0.0);  // fixed
}

TEST(MassScaling, GivesAllFreeBlocksOneStepAndKeepsMassAndEnergy) {
  Model model = graded();
  const Model before = model;
  begin_mass_scaling(model);
  const Blocks& blocks = model.blocks;
  const Eigen::VectorXd counts = packed_contacts(blocks, 0.01);
  double sum = 0.0;
  for (int b = 0; b <= 10; ++b) {
    const double share = counts[b] / usual_contacts;
    EXPECT_NEAR(0.1 * 2.0 * std::sqrt(blocks.inertial_mass(b) / (share * 1e6)),
                model.time_step.dt, 1e-12 * model.time_step.dt);
    EXPECT_NEAR(kinetic(model, b), kinetic(before, b), 1e-12 * kinetic(before, b));
    sum += blocks.inertial_mass(b);
  }
  EXPECT_NEAR(sum, 60.0, 1e-10);
  EXPECT_EQ(blocks.scale[11], 1.0);
  EXPECT_GT(model.time_step.dt, choose_time_step(before).dt);
  end_mass_scaling(model);
  EXPECT_FALSE(blocks.has_scaled_masses());
  EXPECT_EQ(model.time_step.dt, choose_time_step(before).dt);
  for (int b = 0; b <= 10; ++b)
    EXPECT_NEAR(kinetic(model, b), kinetic(before, b), 1e-12 * kinetic(before, b));
}

// m' dv/dt = F + m g - alpha |F + m g| v / |v|. Both blocks have the mean mass, 5.
TEST(MassScaling, KeepsWeightsAndForces) {
  Model model = graded();
  model.blocks = {};
  model.blocks.append({rectangle(0, 0, 1, 1)});
  model.blocks.append({rectangle(50, 0, 3, 3)});
  model.settings.local_damping = 0.5;
  model.loads.function = {{0.0}, {1.0}};
  model.loads.forces = {{0, {3.0, 0.0}, TimeFunction::always}};
  model.blocks.velocity << 2.0, 0.0, 0.0, 0.0;
  begin_mass_scaling(model);
  const double dt = model.time_step.dt;
  const Vec2 before = model.blocks.velocity.col(0), force(3.0, -10.0);
  Workspace work;
  step(model, work);
  EXPECT_NEAR(model.blocks.inertial_mass(0), 5.0, 1e-12);
  const Vec2 expected =
      before + dt / 5.0 * (force - 0.5 * force.norm() * before.normalized());
  EXPECT_NEAR((Vec2(model.blocks.velocity.col(0)) - expected).norm(), 0.0, 1e-12);
  EXPECT_NEAR(model.blocks.velocity(1, 1), -dt * 90.0 / 5.0, 1e-12);
}

TEST(MassScaling, IsEndedByTheNextMotion) {
  Model model = graded();
  prepare(model);
  const double dt = model.time_step.dt;
  begin_mass_scaling(model);
  prepare(model);
  EXPECT_FALSE(model.blocks.has_scaled_masses());
  EXPECT_EQ(model.time_step.dt, dt);
}

TEST(MassScaling, NeedsAFreeBlockAndNoQuietSides) {
  Model model = graded();
  EXPECT_TRUE(may_scale_masses(model));
  model.loads.quiet_sides = {{0, 0, 1.0, 1.0}};
  EXPECT_FALSE(may_scale_masses(model));
  model = graded();
  model.settings.mass_scaling = false;
  EXPECT_FALSE(may_scale_masses(model));
}

// The elastic step of a deformable block grows with the root of its density.
TEST(MassScaling, CountsTheDeformabilityOfBlocks) {
  Model model = graded(false);
  const Eigen::VectorXd steps = steps_of_blocks(model, Eigen::VectorXd::Ones(12));
  begin_mass_scaling(model);
  const double root = model.time_step.dt / steps[1];
  EXPECT_LT(steps[1], 0.1 * 2.0 * std::sqrt(1.0 / 1e6));
  EXPECT_NEAR(model.blocks.scale[1], root * root, 1e-12 * root * root);
}

}  // namespace
}  // namespace blocks::dynamics
