// The audit finds no fault in sound runs.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "audit/clusters.hpp"
#include "audit/moments.hpp"
#include "audit/words.hpp"
#include "model/numbering.hpp"
#include "study/scene_builder.hpp"

namespace blocks {
namespace {

using audit::Findings;
using scenes::Scene;
using testing::audited_step;
using testing::AuditedRun;

/// Steps the model and audits every `every`-th step. The test fails if a step is not
/// sound. Returns the sums of pairs and acting contacts.
Findings audited(Model& model, int steps, int every) {
  AuditedRun run(model);
  Findings sum;
  for (int i = 0; i < steps && sum.sound(); ++i) {
    run.step();
    if (i % every != 0)
      continue;
    const Findings found = run.audit();
    sum.pairs += found.pairs, sum.acting += found.acting;
    sum.missed = found.missed, sum.wrong = found.wrong;
    for (const audit::BlockPair& missed : found.missed)
      ADD_FAILURE() << "step " << i << ": " << audit::tell(missed);
    for (const audit::WrongPair& wrong : found.wrong)
      ADD_FAILURE() << "step " << i << ": " << audit::tell(run.before, wrong);
  }
  return sum;
}

TEST(Audit, FindsNoFaultInRubble) {
  long acting = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = testing::rubble(seed);
    scene.prepare();
    acting += audited(scene.model, 1500, 50).acting;
  }
  EXPECT_GT(acting, 1000);
}

// A box slides over a floor of boxes and overlaps it a little. At every joint the next
// box hides a side from it.
TEST(Audit, FindsNoFaultWhileABoxSlidesOverJoints) {
  long hidden = 0;
  for (const scenes::Frame& frame : scenes::random_frames(8)) {
    Scene scene(frame);
    scene.model.settings.damping = 0.3;
    scene.model.settings.fraction = 0.005;
    scene.model.settings.normal_stiffness = scene.model.settings.shear_stiffness = 2e6;
    for (int i = 0; i < 8; ++i)
      scene.box(i, -1, 1, 1, true);
    const int box = scene.box(0.75, 0, 1, 1);
    scene.gravity(0, -10);
    scene.velocity(box, 1.0, 0.0);
    scene.prepare();
    AuditedRun run(scene.model);
    while (scene.model.time < 0.8) {
      run.step();
      const Findings found = run.audit();
      ASSERT_TRUE(found.sound()) << scene.model.time;
      ASSERT_TRUE(found.excess.empty()) << scene.model.time;
      const auto rule = audit::make_exact_rule(run.before, 0.0);
      for (const int b : rule.neighbours(box))
        for (const audit::PartDecision& parts : rule.decide(box, b).parts)
          hidden += std::count_if(parts.axes.begin(), parts.axes.end(),
                                  [](const audit::Axis& a) { return a.hidden(); });
    }
  }
  EXPECT_GT(hidden, 100);
}

/// Returns the number of contacts deeper than 5 % of the size of the smaller block.
long deep_contacts(const Model& model) {
  const Blocks& blocks = model.blocks;
  long deep = 0;
  for (const Contact& contact : model.contacts) {
    const auto [a, b] = pair_of(blocks, contact);
    deep +=
        contact.overlap > 0.05 * std::sqrt(std::min(blocks.area[a], blocks.area[b]));
  }
  return deep;
}

TEST(Audit, FindsNoFaultInDeepOverlaps) {
  Findings sum;
  long deep = 0;
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    Model model = study::scenes::SceneBuilder("cluster", "", 0).model();
    model.settings.lower = {-200, -200}, model.settings.upper = {200, 200};
    testing::Clusters clusters(static_cast<std::uint64_t>(k));
    model.blocks.append(clusters.make(k % testing::Clusters::kinds));
    if (model.blocks.size() < 2)
      continue;
    dynamics::prepare(model);
    const Findings found = audited(model, 1, 1);
    sum.pairs += found.pairs, sum.acting += found.acting;
    deep += deep_contacts(model);
  }
  EXPECT_GT(sum.pairs, 5000);
  EXPECT_GT(sum.acting, 5000);
  EXPECT_GT(deep, 2000);
}

/// Returns unit boxes on a floor, numbered from the top. All are shifted against each
/// other by the same exact amount, so that many axes are equally deep.
Model tied_boxes() {
  Scene scene;
  scene.model.settings.damping = 0.2;
  for (int row = 14; row >= 0; --row)
    for (int i = 0; i < 20; ++i)
      scene.box(0.9375 * ((7 * i + row) % 20), 0.9375 * row, 1, 1);
  scene.box(-1, -1, 22, 1.0625, true);
  scene.gravity(0, -10);
  scene.prepare();
  return scene.model;
}

// A model with an internal order breaks ties by that order, and so does the judge.
TEST(Audit, FindsNoFaultInAModelWithAnInternalOrder) {
  Model model = tied_boxes();
  model.order = strip_order(model.blocks);
  ASSERT_EQ(model.order.size(), 301U);
  EXPECT_GT(audited(model, 200, 20).acting, 1000);
}

// Some blocks are not convex, and their parts are renumbered, too.
TEST(Audit, FindsNoFaultInRubbleWithAnInternalOrder) {
  for (const std::uint64_t seed : {2U, 3U, 6U, 7U}) {
    SCOPED_TRACE(seed);
    Scene scene = testing::rubble(seed);
    scene.prepare();
    for (int b = scene.model.blocks.size() - 1; b >= 0; --b)
      scene.model.order.push_back(b);
    EXPECT_GT(audited(scene.model, 1500, 50).acting, 100);
  }
}

// Two bars cross, and no corner is inside the other block. The least axis is entered
// beyond the ends of its side.
TEST(Audit, ExplainsTheOverlapOfCrossedBarsByTheirContacts) {
  Scene scene;
  scene.box(-2, -0.5, 4, 1, true);
  scene.box(-0.25, -2, 0.5, 4);
  const Findings found = audited_step(scene);
  EXPECT_TRUE(found.sound());
  EXPECT_EQ(found.acting, 2);
  EXPECT_TRUE(found.excess.empty());
}

TEST(Audit, ExplainsTheOverlapOfABlockAtRestByItsContacts) {
  Scene scene;
  scene.model.settings.damping = 0.3;
  scene.box(-2, -1, 4, 1, true);
  scene.box(-0.5, 0, 1, 1);
  scene.gravity(0, -10);
  scene.run(2.0);
  const Findings found = audited_step(scene);
  EXPECT_TRUE(found.sound());
  EXPECT_EQ(found.acting, 2);
  EXPECT_TRUE(found.excess.empty());
  EXPECT_LT(found.worst.excess(), 1e-12);
}

}  // namespace
}  // namespace blocks
