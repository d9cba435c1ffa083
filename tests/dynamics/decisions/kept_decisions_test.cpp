// Decisions that outlive a search, cracks or a checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/decisions/decisions.hpp"
#include "dynamics/stepper.hpp"
#include "geometry/contact_constants.hpp"
#include "study/scene_builder.hpp"
#include "tools/fields.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

PairIndex index_of(std::vector<NearPair> pairs, int blocks) {
  PairIndex index;
  index.take(pairs, blocks);
  return index;
}

/// Certain decisions of all pairs, which depend on neighbours if `until` is finite.
Decisions made(const PairIndex& index, double until) {
  Decisions decisions;
  for (int p = 0; p < index.size(); ++p) {
    decisions.pairs.push_back(
        {.validity = {.distance = 1.0 + p, .until = until, .pose = {}},
         .renewal = nullptr,
         .examined_at_pair_path = 0.5 + p,
         .examined_at_longest_path = infinite});
    decisions.next_check.push_back(0.25 + p);
  }
  return decisions;
}

std::vector<double> distances_of(const Decisions& decisions) {
  std::vector<double> distances;
  for (const PairDecision& one : decisions.pairs)
    distances.push_back(one.validity.distance);
  return distances;
}

// A row of six blocks. A search finds that blocks 0 and 2 are near, and no longer lists
// blocks 4 and 5.
const std::vector<NearPair> row = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}};
const std::vector<NearPair> later = {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}};

TEST(KeptDecisions, OutliveASearch) {
  const PairIndex old = index_of(row, 6), now = index_of(later, 6);
  Decisions decisions = made(old, infinite);
  decisions.keep_in(now, old, {});
  EXPECT_EQ(distances_of(decisions), (std::vector<double>{1, 0, 2, 3, 4}));
  EXPECT_EQ(decisions.next_check, (std::vector<double>{0.25, 0, 1.25, 2.25, 3.25}));
}

TEST(KeptDecisions, EndIfANewNeighbourMayMatter) {
  const PairIndex old = index_of(row, 6), now = index_of(later, 6);
  Decisions decisions = made(old, 10.0);
  decisions.keep_in(now, old, {});
  // Blocks 0 and 2 have a new neighbour. Blocks 3 and 4 have lost one at most.
  EXPECT_EQ(distances_of(decisions), (std::vector<double>{0, 0, 0, 0, 4}));
}

TEST(KeptDecisions, EndIfABlockOrANeighbourHasSplit) {
  std::vector<NearPair> pairs = row;
  pairs.push_back({4, 6});  // block 6 has split off block 5
  const PairIndex old = index_of(row, 6), now = index_of(pairs, 7);
  const std::vector<char> changed = {0, 0, 0, 0, 0, 1, 1};
  Decisions alone = made(old, infinite), among_others = made(old, 10.0);
  alone.keep_in(now, old, changed);
  among_others.keep_in(now, old, changed);
  EXPECT_EQ(distances_of(alone), (std::vector<double>{1, 2, 3, 4, 0, 0}));
  EXPECT_EQ(distances_of(among_others), (std::vector<double>{1, 2, 3, 0, 0, 0}));
}

/// The fields of the decisions that a checkpoint contains, as one text.
std::map<std::string, std::string> fields_of(Model& model) {
  samples::Fields fields;
  output::visit_model(model, fields);
  return std::move(fields.all);
}

/// Four columns of squares side by side between two walls, whose joints cross in
/// points, and a square that falls on them.
struct Heap {
  explicit Heap(bool reversed)
      : model(study::scenes::SceneBuilder("heap", "", 0).model()) {
    model.settings.lower = {-20, -20}, model.settings.upper = {20, 20};
    model.settings.gravity = {0.0, -9.81};
    model.settings.damping = 0.3;
    const auto add = [&](double x, double y, double width, double lean, bool fixed) {
      NewBlock block;
      block.outline = {
          {x, y}, {x + lean, y + 1}, {x + width + lean, y + 1}, {x + width, y}};
      block.density = 2000.0;
      block.fixity = fixed ? Fixity::by_user : Fixity::free;
      model.blocks.append({block});
    };
    add(-2, -1, 8, 0, true);
    for (int level = 0; level < 4; ++level)
      add(-1, level, 1.001, 0, true), add(3.999, level, 1, 0, true);
    for (int column = 0; column < 4; ++column)
      for (int level = 0; level < 4; ++level)
        add(column, level, 1, 0, false);
    add(1.7, 4.2, 1, 0.3, false);
    prepare(model);
    for (int b = model.blocks.size() - 1; reversed && b >= 0; --b)
      model.order.push_back(b);
  }
  void step(int steps) {
    for (int i = 0; i < steps; ++i)
      stepper.advance(false);
  }
  Model model;
  Workspace work;
  Stepper stepper{model, work};
};

// A copy of the model with its decisions goes on with the same bits, and keeps the same
// decisions.
TEST(KeptDecisions, AreStateThatACopyGoesOnWith) {
  for (const bool reversed : {false, true}) {
    Heap heap(reversed);
    heap.step(600);
    Model copy = heap.stepper.complete();
    long by_exact_rule = 0;
    for (const KeptPair& pair : copy.kept.pairs)
      by_exact_rule += pair.poses > 0;
    EXPECT_GT(by_exact_rule, 5);
    Workspace work;
    Stepper stepper(copy, work);
    for (int i = 0; i < 500; ++i)
      stepper.advance(false);
    heap.step(500);
    stepper.complete(), heap.stepper.complete();
    EXPECT_EQ(fields_of(copy), fields_of(heap.model));
  }
}

/// Adds laws to a heap whose squares are thrown apart, so that pairs lose all contacts
/// and get others.
Model thrown(bool with_laws, bool in_situ, unsigned seed) {
  Model model = Heap(false).model;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> velocity(-3.0, 3.0);
  for (int b = 0; b < model.blocks.size(); ++b)
    if (model.blocks.fixity[b] == Fixity::free)
      model.blocks.velocity.col(b) = Vec2(velocity(random), velocity(random)),
      model.blocks.spin[b] = velocity(random);
  if (with_laws) {
    JointLaw law;
    law.friction = law.residual_friction = 0.5;
    law.cohesion = law.tension = 1e3;
    law.normal_stiffness = law.shear_stiffness = 1e7;
    model.settings.joint_laws[1] = law;
    model.settings.joint_of_materials[{0, 0}] = 1;
  }
  model.settings.in_situ = in_situ;
  prepare(model);
  return model;
}

// A run that is copied again and again has the bits of a run that is not.
TEST(KeptDecisions, AreStateWhateverHasStates) {
  for (const bool with_laws : {false, true})
    for (const bool in_situ : {false, true})
      for (unsigned seed = 1; seed <= 2; ++seed) {
        Model through = thrown(with_laws, in_situ, seed), model = through;
        Workspace work;
        Stepper stepper(through, work);
        for (int part = 0; part < 20; ++part) {
          Workspace new_work;
          Stepper new_stepper(model, new_work);
          for (int i = 0; i < 31; ++i)
            stepper.advance(false), new_stepper.advance(false);
          new_stepper.complete();
        }
        stepper.complete();
        ASSERT_EQ(fields_of(model), fields_of(through))
            << (with_laws ? "laws " : "") << (in_situ ? "INSITU " : "") << seed;
      }
}

/// Three boxes of size 1 in a row; the pair of the first two has a kept decision.
struct Row {
  Model model;
  BlockParts parts;
  PairIndex index = index_of({{0, 1}, {1, 2}}, 3);
  Decisions decisions;

  Row() {
    for (const double x : {0.0, 1.0, 2.0}) {
      NewBlock block;
      block.outline = {{x, 0}, {x, 1}, {x + 1, 1}, {x + 1, 0}};
      block.density = 1.0;
      model.blocks.append({block});
    }
    parts.make(model.blocks);
    decisions.bounds.start(model.blocks, true);
    decisions.reset(2);
  }
  void keep(const std::vector<KeptDepth>& depths) {
    decisions.keep_exact(model.blocks, parts, index, 0, depths, true);
  }
  bool holds() {
    decisions.bounds.grow(1e-2);
    decisions.pairs[0].examined_at_pair_path = 0.0;
    decisions.pairs[0].examined_at_longest_path = 0.0;
    return decisions.holds(model.blocks, parts, index.pairs[0], 0);
  }
};

// A decision of the exact rule is made again when a block or a neighbour has moved by
// the renewal distance, but not if all of them move together.
TEST(KeptDecisions, OfTheExactRuleEndAfterTheRenewalDistance) {
  Row three;
  Blocks& blocks = three.model.blocks;
  const double distance = geometry::renewal_of_arm * three.decisions.bounds.longest[0];
  three.keep({});
  EXPECT_TRUE(three.holds());
  blocks.centroid.colwise() += Vec2(3.0, 5.0);
  EXPECT_TRUE(three.holds());
  blocks.centroid(0, 2) += 0.9 * distance;  // a neighbour of block 1
  EXPECT_TRUE(three.holds());
  blocks.centroid(0, 2) += 0.2 * distance;
  EXPECT_FALSE(three.holds());
  Row turned;
  turned.keep({});
  EXPECT_TRUE(turned.holds());
  turned.model.blocks.gradient.col(1) = Eigen::Vector4d(1.0, -distance, distance, 1.0);
  EXPECT_FALSE(turned.holds());
}

// Corners of a deck may be rounded otherwise than those that follow from the pose. A
// decision about them is for this step alone, because the audit could not repeat it.
TEST(KeptDecisions, OfTheExactRuleAreNotKeptForCornersOfTheDeck) {
  Row three;
  three.model.blocks.corner(0, 8) += 0x1p-50;  // of a neighbour
  three.keep({});
  EXPECT_FALSE(three.holds());
}

// It is also made again when a depth leaves its limits. Here it is that of the second
// box below the right side of the first one.
TEST(KeptDecisions, OfTheExactRuleEndWhenADepthLeavesItsLimits) {
  Row three;
  const KeptDepth depth{
      .own_block = 0, .other_block = 1, .side = 2, .min = -1e-8, .max = 3e-8};
  const auto shifted = [&](double by) {
    for (int corner = 4; corner < 8; ++corner)
      three.model.blocks.corner(0, corner) -= by;
  };
  three.keep({depth});
  EXPECT_TRUE(three.holds());
  for (const double by : {2.9e-8, -3.8e-8}) {
    shifted(by);
    EXPECT_TRUE(three.holds());
  }
  shifted(-0.2e-8);
  EXPECT_FALSE(three.holds());
  shifted(4.2e-8);
  EXPECT_FALSE(three.holds());
}

}  // namespace
}  // namespace blocks::dynamics
