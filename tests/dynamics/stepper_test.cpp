// The stepper steps a model in an internal order of its blocks. Results change by
// round-off only, and their bits depend on nothing else than the order.
#include "dynamics/stepper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Scene;

/// Returns leaning bricks, numbered at random. They slide on a floor away from a plane,
/// are pushed, and leave the domain on the right one after the other.
Model heap(bool rigid) {
  Scene scene;
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.5, s.damping = 0.2, s.contact_tolerance = 0.02;
  s.upper = {8.5, 200};
  scene.box(-2, -1, 9, 1, true);
  std::vector<geometry::Polygon> bricks;
  for (int row = 0; row < 8; ++row)
    for (int i = 0; i < 8; ++i) {
      const double lean = 0.05 * ((7 * i + 3 * row) % 5 - 2), y = 1.001 * row;
      const double x = i + 0.3 * (row % 2);
      bricks.push_back(
          {{x, y}, {x + lean, y + 1}, {x + 0.98 + lean, y + 1}, {x + 0.98, y}});
    }
  std::mt19937 random(3);
  for (std::size_t i = bricks.size(); i > 1; --i)
    std::swap(bricks[i - 1], bricks[random() % i]);
  for (const geometry::Polygon& brick : bricks)
    scene.velocity(scene.add(brick), 2.0, 0);
  scene.plane({-0.01, 9}, {-0.01, -1});
  scene.gravity(4.0, -10);
  Model model = scene.model;
  model.loads.function = {{0, 1}, {0, 1}};
  model.loads.pressures = {{9, 0, 1e4, 2e4, 0.0}, {5, 1, 1e4, 0, 0.0}};
  model.loads.forces = {{7, {1e4, 0}, 0.0}, {7, {0, 2e4}, 0.0}};
  dynamics::prepare(model);
  model.order = strip_order(model.blocks);
  return model;
}

constexpr int steps = 600;

/// Returns all fields of the model after the steps. `between` is called after each
/// step.
template <class Between>
std::map<std::string, std::string> stepped(Model model, int threads,
                                           Between&& between) {
  dynamics::Workspace work(threads);
  dynamics::Stepper stepper(model, work);
  for (int i = 1; i <= steps; ++i) {
    stepper.advance(i == steps);
    between(i, stepper);
  }
  return fields(stepper.up_to_date());
}
std::map<std::string, std::string> stepped(const Model& model, int threads = 1) {
  return stepped(model, threads, [](int, dynamics::Stepper&) {});
}

TEST(Stepper, GivesTheSameBitsWithAnyNumberOfThreads) {
  for (const bool rigid : {true, false}) {
    const Model model = heap(rigid);
    EXPECT_EQ(stepped(model, 3), stepped(model));
  }
}

TEST(Stepper, GivesTheSameBitsIfTheModelIsReadBetweenSteps) {
  for (const bool rigid : {true, false}) {
    const Model model = heap(rigid);
    const auto straight = stepped(model);
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

// Each step has a new stepper, which knows only the model, as after a checkpoint.
TEST(Stepper, ContinuesFromTheModelAlone) {
  for (const bool rigid : {true, false}) {
    const auto straight = stepped(heap(rigid));
    Model model = heap(rigid);
    for (int i = 1; i <= steps; ++i) {
      dynamics::Workspace work;
      dynamics::Stepper stepper(model, work);
      stepper.advance(i == steps);
      stepper.up_to_date();
    }
    ASSERT_GT(model.exits.size(), 2U);
    ASSERT_GT(model.search.updates, 5);
    ASSERT_GT(model.contacts.size(), 50U);
    EXPECT_EQ(fields(model), straight);
  }
}

TEST(Stepper, GivesTheBitsOfAPlainStepWithoutAnOrder) {
  Model model = heap(true);
  model.order.clear();
  const auto stepped_so = stepped(model);
  dynamics::Workspace work;
  for (int i = 1; i <= steps; ++i)
    dynamics::step(model, work);
  EXPECT_EQ(fields(model), stepped_so);
}

// The order has an effect on the sums of forces only.
TEST(Stepper, ChangesResultsByRoundOffOnly) {
  Model inside = heap(true), outside = heap(true);
  dynamics::Workspace work, others;
  dynamics::Stepper stepper(inside, work);
  for (int i = 0; i < 100; ++i) {
    const dynamics::StepResult moved = stepper.advance(true);
    const dynamics::StepResult told = dynamics::step(outside, others);
    EXPECT_NEAR(moved.largest, told.largest, 1e-12);
  }
  stepper.up_to_date();
  EXPECT_TRUE(std::equal(inside.contacts.begin(), inside.contacts.end(),
                         outside.contacts.begin(), outside.contacts.end(),
                         [](const Contact& l, const Contact& r) {
                           return l.corner == r.corner && l.edge == r.edge;
                         }));
  EXPECT_EQ(inside.blocks.first_corner, outside.blocks.first_corner);
  EXPECT_LT((inside.blocks.corner - outside.blocks.corner).cwiseAbs().maxCoeff(),
            1e-12);
  EXPECT_LT((inside.blocks.velocity - outside.blocks.velocity).cwiseAbs().maxCoeff(),
            1e-9);
}

// Two blocks leave the domain in the same step.
TEST(Stepper, ReportsBlocksByTheNumbersOfTheDeck) {
  Scene scene;
  for (int i = 0; i < 6; ++i)
    scene.box(0, 3 * i, 1, 1);
  scene.velocity(4, 2e9, 0);
  scene.velocity(1, 1e9, 0);
  scene.prepare();
  scene.model.order = {5, 4, 3, 2, 1, 0};
  dynamics::Workspace work;
  dynamics::Stepper stepper(scene.model, work);
  EXPECT_EQ(stepper.advance(false).block, 4);
  ASSERT_EQ(scene.model.exits.size(), 2U);
  EXPECT_EQ(scene.model.exits[0].block, 1);
  EXPECT_EQ(scene.model.exits[1].block, 4);
  EXPECT_TRUE(stepper.up_to_date().blocks.is_free(0));
  EXPECT_FALSE(scene.model.blocks.is_free(1));
}

}  // namespace
}  // namespace blocks
