// Blocks that split (docs/cracks.md): when, where, and what the pieces take with them.
#include "dynamics/cracks/cracking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "dynamics/cracks/pieces.hpp"
#include "dynamics/energy/block_energy.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "dynamics/stepper.hpp"
#include "scenes/joint_law.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Frame;
using scenes::Scene;
using scenes::three_frames;

constexpr double strength = 1e6;

/// A deformable block without Poisson's effect, whose sides 0 and 2 are pulled.
struct Pulled : Scene {
  explicit Pulled(const Frame& frame, double pull, double length = 1.0) : Scene(frame) {
    Settings& s = model.settings;
    s.rigid = false;
    s.materials[1] = {1e10, 5e9, 2500.0};
    s.crack_rules[1] = {strength, 0.01};
    s.fraction = 0.001;
    box(-0.5 * length, -0.5, length, 1.0);
    model.loads.function = {{0, 1}, {1, 1}};
    model.loads.pressures = {{0, 0, -pull, -pull, 0.0}, {0, 2, -pull, -pull, 0.0}};
  }
};

/// Steps a model and splits blocks after each step.
class Motion {
 public:
  explicit Motion(Model& model, int threads = 1)
      : work_(threads), stepper_(model, work_) {
    dynamics::prepare(model);
  }
  int step(bool read = false) {
    stepper_.advance(read);
    return stepper_.crack();
  }
  const Model& model() { return stepper_.up_to_date(); }
  void before_split(std::function<void()> call) { stepper_.before_split = call; }

 private:
  dynamics::Workspace work_;
  dynamics::Stepper stepper_;
};

struct Momenta {
  Vec2 linear = {0, 0};
  double angular = 0.0;
  explicit Momenta(const Model& model)
      : linear(totals(model).momentum), angular(totals(model).angular_momentum) {}
};

// s(t) = p (1 - cos 4000 t) reaches the strength at acos(1 - 1 / .6) / 4000.
TEST(Cracks, SuddenPullCracksWhenTheWaveReachesTheStrength) {
  for (const Frame& frame : {Frame{}, Frame{std::numbers::pi / 2, {3, -2}},
                             Frame{-std::numbers::pi, {1000, 500}}}) {
    Pulled scene(frame, 0.6e6);
    Motion run(scene.model);
    while (run.step() == 0)
      ASSERT_LT(scene.model.time, 0.01);
    EXPECT_NEAR(scene.model.time, 0.00057513, 2.0 * scene.dt());
    EXPECT_EQ(scene.model.blocks.size(), 2);
  }
}

TEST(Cracks, SuddenPullOfLessThanHalfTheStrengthNeverCracks) {
  Pulled scene({0.7, {3, -2}}, 0.49e6);
  Motion run(scene.model);
  for (int i = 0; i < 3000; ++i)
    ASSERT_EQ(run.step(), 0);
  EXPECT_GT(scene.model.time, 3 * 2 * std::numbers::pi / 4000);
}

TEST(Cracks, SlowPullSplitsInEqualHalvesAndReleasesTheStrainEnergy) {
  for (const Frame& frame : three_frames) {
    Pulled scene(frame, 1.25e6);
    scene.model.loads.function = {{0, 0.2}, {0, 1}};
    scene.model.settings.materials[1].damping = 0.5;
    Motion run(scene.model);
    while (run.step() == 0)
      ASSERT_LT(scene.model.time, 0.2);
    ASSERT_EQ(scene.model.cracks.size(), 1U);
    const CrackRecord& crack = scene.model.cracks.front();
    EXPECT_NEAR(crack.stress, strength, 0.001 * strength);
    EXPECT_NEAR(scene.model.loads.function.factor(scene.model.time, 0) * 1.25e6,
                strength, 0.01 * strength);
    EXPECT_NEAR(crack.parent_area, 0.5, 1e-4);
    EXPECT_NEAR(crack.child_area, crack.parent_area, 1e-12);
    EXPECT_NEAR(crack.strain_before - crack.strain_after, 50.0, 0.2);
    EXPECT_NEAR(crack.kinetic_before, crack.kinetic_after, 0.01);
    EXPECT_NEAR(crack.length(), 1.0, 1e-4);
    EXPECT_EQ(crack.parent, 0);
    EXPECT_EQ(crack.child, 1);
  }
}

TEST(Cracks, AreAtRightAnglesToThePull) {
  for (int k = 0; k < 24; ++k) {
    const double angle = k * std::numbers::pi / 12 + std::numbers::pi / 6;
    Scene scene;
    scene.model.settings.rigid = false;
    scene.model.settings.crack_rules[1] = {strength, 0.001};
    scene.add({{-1, -0.6}, {-0.7, 0.8}, {0.9, 0.7}, {0.8, -0.9}});
    const double c = std::cos(angle), s = std::sin(angle);
    scene.model.blocks.stress.col(0) =
        1.1e6 * Eigen::Vector4d(c * c, c * s, c * s, s * s);
    scene.prepare();
    dynamics::Workspace work;
    ASSERT_EQ(dynamics::crack_blocks(scene.model, work, {}), 1);
    const CrackRecord& crack = scene.model.cracks.front();
    const Vec2 along = (crack.to - crack.from).normalized();
    EXPECT_NEAR(along.dot(Vec2(c, s)), 0.0, 1e-12) << angle;
  }
}

// 104,166.7 J of a spinning block are 62,500 J of its halves and 41,666.7 J of their
// spins.
TEST(Cracks, PiecesOfASpinningBlockKeepItsMotion) {
  for (const Frame& frame : three_frames) {
    Scene scene(frame);
    scene.model.settings.materials[1].density = 2500.0;
    scene.box(-1, -0.5, 2, 1);
    scene.velocity(0, 0, 0, 10.0);
    const Vec2 across = frame.turn({0, 1});
    const BlockSplit split = dynamics::pieces_of(
        scene.model.blocks, 0,
        geometry::split_outline(scene.model.blocks.outline(0),
                                {scene.model.blocks.centroid.col(0), across}, 0.1));
    double centroids = 0.0, spins = 0.0;
    for (const Piece& piece : split.pieces) {
      EXPECT_NEAR(piece.velocity.norm(), 5.0, 1e-9);
      EXPECT_NEAR(piece.spin, 10.0, 1e-9);
      centroids += 0.5 * piece.mass * piece.velocity.squaredNorm();
      spins += 0.5 * piece.inertia * piece.spin * piece.spin;
    }
    EXPECT_NEAR(centroids, 62500.0, 1e-5);
    EXPECT_NEAR(spins, 41666.666666666667, 1e-5);
  }
}

/// A heap of deformable bricks of several shapes that crack as they fall.
Model shattering(const Frame& frame, bool rigid) {
  Scene scene(frame);
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.damping = 0.2, s.friction = 0.5;
  s.materials[1] = {1e8, 4e7, 2000.0};
  s.crack_rules[1] = {rigid ? 4e4 : 6e4, 0.1, 8e4, 3};
  s.contact_tolerance = 0.02;
  scene.box(-2, -1, 24, 1, true);
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 12; ++i) {
      const double lean = 0.05 * ((7 * i + 3 * row) % 5 - 2);
      const double x = i + 0.3 * (row % 2), y = 1.05 * row;
      scene.add({{x, y}, {x + lean, y + 1}, {x + 0.98 + lean, y + 1}, {x + 0.98, y}});
      scene.velocity(scene.model.blocks.size() - 1, 3.0 * (i % 3 - 1), -4.0, 0.5);
    }
  scene.gravity(0.5, -10);
  return scene.model;
}

TEST(Cracks, KeepMomentumAndAngularMomentum) {
  for (const Frame& frame : three_frames)
    for (const bool rigid : {true, false}) {
      Model model = shattering(frame, rigid);
      dynamics::Workspace work;
      dynamics::Stepper stepper(model, work);
      dynamics::prepare(model);
      int cracks = 0;
      for (int i = 0; i < 600 && cracks < 40; ++i) {
        stepper.advance(false);
        const Momenta before(stepper.up_to_date());
        const double mass = model.blocks.mass.sum();
        cracks += stepper.crack();
        const Momenta after(model);
        const double speed = 1.0 + totals(model).fastest;
        EXPECT_NEAR(model.blocks.mass.sum(), mass, 1e-12 * mass);
        EXPECT_LT((after.linear - before.linear).norm(), 1e-13 * mass * speed);
        const double arm = 30.0 + frame.offset.norm();
        EXPECT_LT(std::abs(after.angular - before.angular), 1e-13 * mass * speed * arm);
      }
      EXPECT_GE(cracks, 40) << rigid;
    }
}

TEST(Cracks, AreAccountedForInTheEnergies) {
  for (const bool rigid : {true, false}) {
    Model model = shattering(three_frames[1], rigid);
    model.history.quantities = {"energy:cracks"};
    Motion run(model);
    for (int i = 0; i < 300; ++i) {
      run.step();
      ASSERT_LT(std::abs(model.energy.residual()), 1e-10 * model.energy.at_play());
    }
    ASSERT_GT(model.cracks.size(), 10U);
    double released = 0.0, sizes = 0.0;
    for (const CrackRecord& crack : model.cracks)
      released += crack.released(), sizes += std::abs(crack.released());
    EXPECT_NEAR(model.energy.of(EnergyEntry::cracks), released,
                1e-9 * sizes + 1e-13 * model.energy.at_play());
  }
}

/// All fields after steps in which blocks crack. `between` is called after each step.
template <class Between>
std::map<std::string, std::string> stepped(Model model, int threads,
                                           Between&& between) {
  dynamics::Workspace work(threads);
  dynamics::Stepper stepper(model, work);
  dynamics::prepare(model);
  for (int i = 1; i <= 300; ++i) {
    stepper.advance(i == 300);
    stepper.crack();
    between(i, stepper);
  }
  EXPECT_GT(model.cracks.size(), 10U);
  return fields(stepper.up_to_date());
}
std::map<std::string, std::string> stepped(const Model& model, int threads = 1) {
  return stepped(model, threads, [](int, dynamics::Stepper&) {});
}

TEST(Cracks, GiveTheSameBitsWithAnyNumberOfThreadsAndReadings) {
  for (const bool rigid : {true, false}) {
    const Model model = shattering({}, rigid);
    const auto straight = stepped(model);
    EXPECT_EQ(stepped(model, 3), straight);
    EXPECT_EQ(stepped(model, 1,
                      [](int i, dynamics::Stepper& stepper) {
                        if (i % 7 == 0)
                          stepper.up_to_date();
                        if (i % 35 == 0)
                          stepper.changed();
                      }),
              straight);
  }
}

/// The same heap, stepped in the reverse order of its blocks, beside a plane.
Model in_other_order(bool rigid) {
  Model model = shattering({}, rigid);
  model.settings.planes.push_back({{-0.5, 9}, {-0.5, -1}});
  dynamics::prepare(model);
  for (int b = model.blocks.size() - 1; b >= 0; --b)
    model.order.push_back(b);
  return model;
}

// A run writes checkpoints now and then, by the clock. Their decisions are old when the
// next block splits.
TEST(Cracks, GiveTheSameBitsWithAnyCheckpoints) {
  for (const bool rigid : {true, false})
    for (const Model& model : {shattering({}, rigid), in_other_order(rigid)}) {
      const auto straight = stepped(model);
      for (const int every : {7, 23, 110})  // not after the last step
        EXPECT_EQ(stepped(model, 1,
                          [&](int i, dynamics::Stepper& stepper) {
                            if (i % every == 0)
                              stepper.complete();
                          }),
                  straight)
            << every;
    }
}

// Each step has a new stepper, which knows only the model and its kept decisions, as
// after a checkpoint.
TEST(Cracks, ContinueFromTheModelAlone) {
  for (const bool rigid : {true, false}) {
    const auto straight = stepped(in_other_order(rigid));
    Model model = in_other_order(rigid);
    for (int i = 1; i <= 300; ++i) {
      dynamics::Workspace work;
      dynamics::Stepper stepper(model, work);
      stepper.advance(i == 300);
      stepper.crack();
      stepper.complete();
    }
    model.kept = {};
    EXPECT_EQ(fields(model), straight);
  }
}

// The internal order changes sums of forces by round-off. The first cracks are the same
// and have the same numbers.
TEST(Cracks, HaveTheNumbersOfTheDeckInAnyOrderOfTheSteps) {
  for (const bool rigid : {true, false}) {
    Model plain = shattering({}, rigid), ordered = plain;
    Motion one(plain), other(ordered);
    for (int b = ordered.blocks.size() - 1; b >= 0; --b)
      ordered.order.push_back(b);
    while (plain.cracks.size() < 8) {
      const int cracks = one.step();
      ASSERT_EQ(other.step(), cracks);
    }
    other.model();
    ASSERT_EQ(ordered.cracks.size(), plain.cracks.size());
    for (std::size_t i = 0; i < plain.cracks.size(); ++i) {
      EXPECT_EQ(ordered.cracks[i].parent, plain.cracks[i].parent);
      EXPECT_EQ(ordered.cracks[i].child, plain.cracks[i].child);
      EXPECT_NEAR((ordered.cracks[i].from - plain.cracks[i].from).norm(), 0.0, 1e-6);
    }
    EXPECT_EQ(ordered.blocks.first_corner, plain.blocks.first_corner);
    EXPECT_EQ(ordered.order.size(), static_cast<std::size_t>(plain.blocks.size()));
  }
}

TEST(Cracks, AreAnnouncedWhileTheBlocksHaveTheNumbersOfTheDeck) {
  Model model = shattering({}, true);
  for (int b = model.blocks.size() - 1; b >= 0; --b)
    model.order.push_back(b), model.blocks.layer[static_cast<std::size_t>(b)] = b;
  Motion motion(model);
  const std::vector<int> numbered = model.blocks.layer;
  std::vector<int> announced;
  motion.before_split([&] { announced = model.blocks.layer; });
  while (motion.step() == 0) {
  }
  EXPECT_EQ(announced, numbered);
}

TEST(Cracks, StopAtTheNumberOfBlocksThatStartAllows) {
  Model model = shattering({}, false);
  model.settings.max_blocks = model.blocks.size() + 5;
  Motion run(model);
  for (int i = 0; i < 300; ++i)
    run.step();
  EXPECT_EQ(model.blocks.size(), model.settings.max_blocks);
  EXPECT_GT(count_refused(model.crack_refusals, CrackRefusal::full), 0U);
}

TEST(Cracks, GiveNoPieceBelowTheLeastArea) {
  Model model = shattering({}, false);
  model.settings.crack_rules[1].strength = 1e3;
  model.settings.crack_rules[1].min_area = 0.3;
  Motion run(model);
  for (int i = 0; i < 200; ++i)
    run.step();
  for (int b = 1; b < model.blocks.size(); ++b)
    EXPECT_GE(model.blocks.area[b], 0.3);
  EXPECT_GT(model.cracks.size(), 20U);
  EXPECT_GT(count_refused(model.crack_refusals, CrackRefusal::small), 20U);
}

TEST(Cracks, LeaveTheTimeStep) {
  Model model = shattering({}, false);
  Motion run(model);
  const double dt = model.time_step.dt;
  for (int i = 0; i < 300; ++i)
    run.step();
  ASSERT_GT(model.cracks.size(), 10U);
  EXPECT_EQ(model.time_step.blocks, model.blocks.size());
  dynamics::prepare(model);
  EXPECT_EQ(model.time_step.dt, dt);
  EXPECT_GE(dynamics::choose_time_step(model).dt, dt);
}

// 2 F / (pi D) of a disc of 1 m reaches 1 MPa at 1.5708 MN per m.
TEST(Cracks, DiscSplitsAlongItsLoad) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : three_frames) {
      Scene scene(frame);
      Settings& s = scene.model.settings;
      s.rigid = rigid;
      s.fraction = 0.005, s.damping = 0.3, s.contact_tolerance = 0.01;
      s.normal_stiffness = s.shear_stiffness = 1e9;
      s.crack_rules[1] = {1e9, 0.05, strength};
      scene.box(-1, -1.5, 2, 1, true);
      geometry::Polygon disc;
      for (int i = 0; i < 32; ++i) {
        const double angle = 2 * std::numbers::pi * i / 32;
        disc.emplace_back(0.5 * std::sin(angle), 0.5 * std::cos(angle));
      }
      scene.add(disc);
      const int plate = scene.box(-1, 0.5, 2, 0.2);
      s.crack_rules[2] = {1e12, 1.0};
      s.materials[2] = s.materials[1];
      scene.model.blocks.material[plate] = 2;
      scene.model.loads.function = {{0, 0.1}, {0, 1}};
      scene.model.loads.forces = {{plate, frame.turn({0, -2e6}), 0.0}};
      Motion run(scene.model);
      while (run.step() == 0)
        ASSERT_LT(scene.model.time, 0.2);
      const CrackRecord& crack = scene.model.cracks.front();
      EXPECT_EQ(crack.cause, CrackCause::point_loads);
      EXPECT_EQ(crack.parent, 1);
      EXPECT_NEAR(scene.model.time / 0.1 * 2e6, 1.5708e6, 0.01e6);
      EXPECT_NEAR(crack.length(), 1.0, 1e-3);
      EXPECT_NEAR(frame.back(crack.to - crack.from).x(), 0.0, 1e-6);
      EXPECT_NEAR(crack.parent_area, crack.child_area, 1e-6);
    }
}

}  // namespace
}  // namespace blocks
