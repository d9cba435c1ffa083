// Simply deformable blocks (docs/theory.md#strain-rates-and-stress).
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/motion.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "model/safe_fraction.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

// Side pressures keep the height, so that eps11 = -p / C11 and sigma22 = C12 / C11
// sigma11. The load grows slowly, so that the block does not oscillate.
TEST(Deformable, HasUniaxialStrainOfStressOverC11) {
  Scene scene;
  scene.model.settings.rigid = false;
  const Material material = scene.model.settings.materials.at(1);
  const double side = material.c12() / material.c11();
  const int b = scene.box(-1, -0.5, 2, 1);
  scene.model.loads.function = {{0, 0.5}, {0, 1}};
  const double p = 1e7;
  scene.model.loads.pressures = {{b, 0, p, p, 0},
                                 {b, 2, p, p, 0},
                                 {b, 1, p * side, p * side, 0},
                                 {b, 3, p * side, p * side, 0}};
  scene.run(0.5);
  const Blocks& blocks = scene.model.blocks;
  const Vec2 extent = dynamics::extent(blocks, b);
  EXPECT_NEAR(std::log(extent.x() / 2.0), -p / material.c11(),
              0.003 * p / material.c11());
  EXPECT_NEAR(std::log(extent.y()), 0.0, 0.003 * p / material.c11());
  EXPECT_NEAR(blocks.stress(0, b), -p, 0.003 * p);
  EXPECT_NEAR(blocks.stress(3, b), -p * side, 0.003 * p);
  EXPECT_NEAR(blocks.stress(1, b), 0, 1e-6 * p);
}

TEST(Deformable, StressTurnsWithTheBlock) {
  Scene scene;
  scene.model.settings.rigid = false;
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.prepare();
  scene.model.blocks.stress.col(b) << 4e6, 1e6, 1e6, -2e6;
  const double turn = 0.3;
  scene.velocity(b, 0, 0, 1.0);
  // One long step rotates the block without the rest of the dynamics.
  dynamics::MotionBounds bounds;
  bounds.start(scene.model.blocks, scene.model.settings.rigid);
  dynamics::move_corners(scene.model.blocks, dynamics::all_of(scene.model.blocks),
                         bounds, scene.model.settings, turn);
  const double c = (1 - 0.0225) / (1 + 0.0225), s = 0.3 / (1 + 0.0225);
  const auto stress = scene.model.blocks.stress.col(b);
  EXPECT_NEAR(stress[0], c * c * 4e6 - 2 * c * s * 1e6 + s * s * -2e6, 1e-6);
  EXPECT_NEAR(stress[3], s * s * 4e6 + 2 * c * s * 1e6 + c * c * -2e6, 1e-6);
  EXPECT_EQ(stress[1], stress[2]);
}

// The wave speed is sqrt(E_eff / rho) with 1/E_eff = 1/E' + w/(n K l). There are n
// contacts on a face of width w, and blocks have the length l.
TEST(Deformable, BarCarriesWavesAtTheTheoreticalSpeed) {
  Scene scene;
  scene.model.settings.rigid = false;
  scene.model.settings.normal_stiffness = scene.model.settings.shear_stiffness = 4e11;
  scene.model.settings.damping = 0.02;
  scene.model.settings.fraction = 0.1;
  constexpr int n = 100;
  for (int i = 0; i < n; ++i)
    scene.box(i, 0, 1, 1);
  scene.plane({-1, 0}, {n + 1, 0});
  scene.plane({n + 1, 1}, {-1, 1});
  scene.plane({0, 1}, {0, 0});
  // The contact law has no tension, so a small pressure keeps every contact closed.
  scene.model.loads.function = {{0, 2e-3, 1}, {0, 1, 1}};
  scene.model.loads.pressures.push_back({n - 1, 2, 1e6, 1e6, 0});
  const Material material = scene.model.settings.materials.at(1);
  const double stiff = 1 / (1 / material.c11() + 1.0 / (4 * 4e11));
  const double c = std::sqrt(stiff / material.density);
  // The wave front passes block i when its stress reaches half the plateau.
  const auto arrival = [&](int i) {
    while (scene.model.blocks.stress(0, i) > -0.5e6 && scene.model.time < 1)
      scene.step();
    return scene.model.time;
  };
  scene.prepare();
  const double far = arrival(80), near = arrival(30);
  EXPECT_NEAR(50.0 / (near - far), c, 0.03 * c);
}

// The step is at most half of l sqrt(rho / C11), where l is the least extent of a
// block.
TEST(TimeStep, IsLimitedByTheWaveSpeedOfDeformableBlocks) {
  Scene scene;
  scene.model.settings.rigid = false;
  scene.model.settings.fraction = 1.0;
  scene.box(0, 0, 2, 0.5);
  scene.prepare();
  const Material material = scene.model.settings.materials.at(1);
  EXPECT_DOUBLE_EQ(scene.dt(), 0.5 * 0.5 * std::sqrt(2000.0 / material.c11()));
  EXPECT_TRUE(scene.model.time_step.elastic);
}

// By (4) the lightest block has the least critical step.
TEST(TimeStep, IsTheFractionOfTheLeastCriticalStep) {
  Scene scene;
  scene.box(0, 0, 2, 1);
  scene.box(3, 0, 0.5, 1);
  scene.prepare();
  EXPECT_DOUBLE_EQ(scene.dt(), 0.02 * 2 * std::sqrt(1000.0 / 1e7));
  EXPECT_EQ(scene.model.time_step.block, 1);
}

// The values are those of a block with eight contacts (docs/theory.md#time-step).
TEST(TimeStep, SafeFractionFallsWithDamping) {
  const double damping[] = {0, .1, .2, .3, .5, .9};
  const double safe[] = {0.144, 0.090, 0.061, 0.044, 0.028, 0.016};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(safe_fraction(damping[i]), safe[i], 0.0005);
}

// Local damping makes springs stiffer on their way out, dashpots act with old
// velocities.
TEST(TimeStep, IsTheSafeOneForTheDampingInForceWithoutFraction) {
  Scene scene;
  scene.box(0, 0, 1, 1);
  scene.model.settings.fraction = 0.0;
  scene.model.settings.damping = 0.3;
  scene.model.settings.local_damping = 0.7;
  scene.prepare();
  EXPECT_DOUBLE_EQ(scene.dt(), safe_fraction(0.3, 0.7) * 2 * std::sqrt(2000.0 / 1e7));
}

}  // namespace
}  // namespace blocks
