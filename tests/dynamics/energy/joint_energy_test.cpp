// The energy account of joints with strength (docs/laws.md#energy).
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/preparation/bond.hpp"
#include "model/drives.hpp"
#include "scenes/joint_law.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

using scenes::cohesive;

const auto& frames = scenes::three_frames;

/// Uses the law, and keeps an energy account.
void use_with_account(Scene& scene, const JointLaw& law) {
  scene.model.history.quantities = {"energy:residual"};
  scenes::use_law(scene, law);
}

void expect_closed(const Model& model) {
  const EnergyAccount& energy = model.energy;
  ASSERT_TRUE(energy.kept);
  EXPECT_GT(energy.at_play(), 0.0);
  EXPECT_LE(std::abs(energy.residual()), 1e-9 * energy.at_play());
}

double of(const Scene& scene, EnergyEntry entry) {
  return scene.model.energy.of(entry);
}

/// A block on a fixed one, pressed down by `pressure` on its top.
Scene pressed(const Frame& frame, const JointLaw& law, double pressure, bool rigid) {
  Scene scene(frame);
  scene.model.settings.rigid = rigid;
  scene.model.settings.normal_stiffness = scene.model.settings.shear_stiffness = 1e9;
  scene.model.settings.damping = 0.3;
  use_with_account(scene, law);
  scene.box(-4, -1, 8, 1, true);
  const int b = scene.box(-0.5, 0, 1, 1);
  scene.model.loads.function = {{0, 0.02, 1}, {0, 1, 1}};
  scene.model.loads.pressures = {{b, 1, pressure, pressure, 0}};
  dynamics::bond_faces(scene.model, 0, 1e-6);
  scene.run(0.1);
  return scene;
}

// A joint that has failed in tension opens against its residual strength. The work goes
// to breaking, and the error of the integration falls with the time step.
TEST(JointEnergy, OfOpeningAgainstResidualTensionGoesToBreaking) {
  double last = 0.0;
  for (const double fraction : {0.05, 0.005}) {
    Scene scene({0.7, {3, -2}});
    scene.model.settings.fraction = fraction;
    JointLaw law = cohesive();
    law.tension = 2e5, law.residual_tension = 5e4;
    use_with_account(scene, law);
    scene.box(-3, -1, 6, 1, true);
    const int b = scene.box(-0.5, 0, 1, 1, true);
    const auto drive = [&](double speed) {
      drive_block(scene.model, {b, Frame{0.7}.turn({0, speed}), 0.0});
    };
    drive(0.0);
    dynamics::bond_faces(scene.model, 0, 1e-6);
    drive(1e-3);
    scene.run(1.0);
    expect_closed(scene.model);
    // The peak is lost at once, and then the residual force acts over 1 mm.
    const double peak = (4e10 - 25e8) / (2.0 * 1e9), opening = 5e4 * (1e-3 - 2e-4);
    EXPECT_NEAR(of(scene, EnergyEntry::breaking), peak + opening, 1e-3 * opening);
    const double error = std::abs(of(scene, EnergyEntry::integration));
    EXPECT_LE(error, 1e-3 * opening);
    if (last > 0.0) {
      EXPECT_NEAR(error, 0.1 * last, 0.05 * last);
    }
    last = error;
  }
}

// The drive of a block that is held at its top shears the joint. It gives what breaking
// and friction take.
TEST(JointEnergy, OfShearGoesToBreakingAndFriction) {
  for (const Frame& frame : frames)
    for (const bool rigid : {true, false}) {
      const double pressure = 1e6, cohesion = 2e5;
      Scene scene = pressed(frame, cohesive(), pressure, rigid);
      const double x0 = scene.centroid(1).x();
      const double before = of(scene, EnergyEntry::loads);
      // A force far above the strength shears the block off.
      scene.model.loads.forces = {{1, frame.turn({1e6, 0}), scene.model.time}};
      scene.run(0.05);
      expect_closed(scene.model);
      const double distance = scene.centroid(1).x() - x0;
      EXPECT_GT(distance, 0.1);
      const double friction = 0.5 * pressure * distance;
      EXPECT_NEAR(of(scene, EnergyEntry::friction), friction, 0.05 * friction);
      // The peak strength is lost: its elastic energy less that of the residual one.
      const double peak = cohesion + 0.5 * pressure, residual = 0.5 * pressure;
      const double lost = (peak * peak - residual * residual) / (2.0 * 1e9);
      EXPECT_NEAR(of(scene, EnergyEntry::breaking), lost, 0.3 * lost);
      EXPECT_NEAR(of(scene, EnergyEntry::loads) - before, 1e6 * distance,
                  0.02 * 1e6 * distance);
    }
}

// Walton's law takes the part 1 - e^2 of the energy of an impact.
TEST(JointEnergy, OfAnImpactGoesToHysteresis) {
  for (const Frame& frame : frames) {
    Scene scene(frame);
    JointLaw law;
    law.kind = LawKind::walton;
    law.restitution = 0.5;
    use_with_account(scene, law);
    scene.model.settings.fraction = 0.005;
    scene.box(-5, -1, 10, 1, true);
    const int b = scene.box(0, 0.001, 1, 1);
    scene.velocity(b, 0, -1);
    scene.run(0.2);
    expect_closed(scene.model);
    const double start = scene.model.energy.start;
    EXPECT_NEAR(scene.velocity(b).y(), 0.5, 0.005);
    EXPECT_NEAR(of(scene, EnergyEntry::hysteresis), 0.75 * start, 0.005 * start);
    EXPECT_NEAR(of(scene, EnergyEntry::integration), 0.0, 0.005 * start);
  }
}

// A block that is sheared under a constant pressure rises by tan(dil) times the slip.
TEST(JointEnergy, OfDilationLiftsTheLoad) {
  for (const Frame& frame : frames) {
    JointLaw law;
    law.friction = law.residual_friction = 0.5;
    law.dilation = 0.2, law.dilation_limit = 0.05;
    law.normal_stiffness = law.shear_stiffness = 1e9;
    const double pressure = 1e6;
    Scene scene = pressed(frame, law, pressure, true);
    // The dashpots would take a part of what dilation gives.
    scene.model.settings.damping = 0.01;
    scene.model.search.invalidate();
    const double y0 = scene.centroid(1).y(), before = of(scene, EnergyEntry::loads);
    scene.model.loads.forces = {{1, frame.turn({5.1e5, 0}), scene.model.time}};
    scene.run(0.2);
    expect_closed(scene.model);
    const double rise = scene.centroid(1).y() - y0, x = scene.centroid(1).x();
    EXPECT_NEAR(rise, 0.2 * 0.05, 0.001);
    EXPECT_NEAR(of(scene, EnergyEntry::dilation), pressure * rise,
                0.1 * pressure * rise);
    EXPECT_NEAR(of(scene, EnergyEntry::loads) - before, 5.1e5 * x - pressure * rise,
                0.02 * 5.1e5 * x);
  }
}

TEST(JointEnergy, ClosesWithBartonsLaw) {
  for (const Frame& frame : frames)
    for (const bool rigid : {true, false}) {
      JointLaw law;
      law.kind = LawKind::barton;
      law.roughness = 10, law.wall_strength = 1e8, law.residual_angle = 30;
      law.peak_slip = 0.004276, law.shear_stiffness = 1e9;
      law.initial_stiffness = 1e9, law.largest_closure = 2e-3;
      law.largest_stiffness = 1e10;
      Scene scene = pressed(frame, law, 1e6, rigid);
      scene.model.loads.forces = {{1, frame.turn({1.3e6, 0}), scene.model.time}};
      scene.run(0.05);
      expect_closed(scene.model);
      EXPECT_GT(of(scene, EnergyEntry::friction), 0.0);
      EXPECT_GT(of(scene, EnergyEntry::dilation), 0.0);
      EXPECT_LT(std::abs(of(scene, EnergyEntry::integration)),
                0.02 * scene.model.energy.at_play());
    }
}

TEST(JointEnergy, OfDrivesIsTakenByFriction) {
  for (const Frame& frame : frames) {
    Scene scene = pressed(frame, cohesive(), 1e5, true);
    drive_block(scene.model, {0, frame.turn({0.01, 0}), 0.0});
    scene.run(0.2);
    expect_closed(scene.model);
    EXPECT_GT(std::abs(of(scene, EnergyEntry::drives)), 0.0);
  }
}

/// A bonded heap that falls and breaks.
Scene bonded_heap(LawKind kind, bool rigid, int threads) {
  Scene scene = scenes::heap(rigid, threads);
  JointLaw law = cohesive();
  law.kind = kind;
  law.normal_stiffness = law.shear_stiffness = 2e7;
  law.cohesion = 3e3, law.tension = 1e3;
  if (kind == LawKind::coulomb)
    law.dilation = 0.2, law.dilation_limit = 0.003;
  else
    law.tension = 0.0, law.restitution = 0.6;
  use_with_account(scene, law);
  dynamics::bond_faces(scene.model, 7, 0.06);
  return scene;
}

TEST(JointEnergy, OfABrokenHeapHasTheSameBitsWithAnyThreadsAndAfterARestart) {
  for (const LawKind kind : {LawKind::coulomb, LawKind::walton})
    for (const bool rigid : {true, false}) {
      Scene one = bonded_heap(kind, rigid, 1), two = bonded_heap(kind, rigid, 2);
      one.steps(1000), two.steps(1000);
      expect_closed(one.model);
      EXPECT_GT(of(one, EnergyEntry::friction), 0.0);
      EXPECT_GT(of(one, EnergyEntry::breaking), 0.0);
      EXPECT_EQ(one.model.energy.sums, two.model.energy.sums);

      Scene first = bonded_heap(kind, rigid, 1);
      first.steps(500);
      Model again = first.model;
      dynamics::Workspace work(1);
      while (again.steps < 1000)
        dynamics::advance(again, work, false);
      EXPECT_EQ(again.energy.sums, one.model.energy.sums);
      EXPECT_EQ(again.energy.errors, one.model.energy.errors);
      EXPECT_EQ(again.energy.elastic, one.model.energy.elastic);
    }
}

// Two bonded blocks spin about their common centroid. Their springs hold them together,
// and do no work.
TEST(JointEnergy, OfASpinningBodyStays) {
  constexpr double spin = 10.0, turns = 4.0;
  for (const bool rigid : {true, false})
    for (const double stiffness : {0.0, 4e8}) {
      Scene scene({0.7, {3, -2}});
      scene.model.settings.rigid = rigid;
      scene.model.settings.fraction = 0.05;
      JointLaw law = cohesive();
      law.cohesion = law.tension = 1e9;
      law.normal_stiffness = stiffness, law.shear_stiffness = 0.5 * stiffness;
      use_with_account(scene, law);
      const int left = scene.box(-1, 0, 1, 1), right = scene.box(0, 0, 1, 1);
      scene.velocity(left, 0, -0.5 * spin, spin);
      scene.velocity(right, 0, 0.5 * spin, spin);
      dynamics::bond_faces(scene.model, 0, 1e-6);
      scene.run(turns * 2.0 * 3.14159265358979 / spin);
      expect_closed(scene.model);
      const EnergyAccount& energy = scene.model.energy;
      EXPECT_NEAR(energy.kinetic + energy.elastic + energy.strain, energy.start,
                  1e-3 * energy.start);
      EXPECT_LE(std::abs(of(scene, EnergyEntry::integration)), 1e-3 * energy.start);
    }
}

}  // namespace
}  // namespace blocks
