// The audit finds what is put wrong on purpose, and nothing in runs that are right.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include "audit/moments.hpp"
#include "audit/words.hpp"

namespace blocks {
namespace {

using audit::Findings;
using scenes::Scene;
using testing::audited_step;
using testing::AuditedStep;
using testing::rubble;

// Two implementations of the rules, in different numbers and from different candidates,
// agree on rubble in any frame, rigid and deformable.
TEST(Audit, RubbleIsClean) {
  long acting = 0, records = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Scene scene = rubble(seed);
    scene.prepare();
    for (int i = 0; scene.model.time < 1.0; ++i) {
      if (i % 50 != 0) {
        scene.step();
        continue;
      }
      const AuditedStep step(scene);
      const Findings found = step.audit(scene);
      ASSERT_TRUE(found.missed.empty())
          << seed << " step " << i << ": " << tell(scene.model.blocks, found.missed[0]);
      ASSERT_TRUE(found.wrong.empty()) << seed << " step " << i;
      acting += found.acting, records += found.records;
    }
  }
  EXPECT_GT(acting, 1000);
  EXPECT_GT(records, acting);
}

// A box slides over a floor of boxes, sunk in by half the reach of the shield: at every
// joint third blocks decide which edge acts.
TEST(Audit, SlidingOverJointsIsClean) {
  long shields = 0;
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
    while (scene.model.time < 0.8) {
      const AuditedStep step(scene);
      const Findings found = step.audit(scene);
      ASSERT_TRUE(found.sound()) << scene.model.time;
      ASSERT_TRUE(found.excess.empty()) << scene.model.time;
      const audit::ExactRules rules(step.before, 0.1);
      const int first = step.before.first_corner[box];
      for (const int corner : {first, first + 3})
        for (const int b : rules.near(corner))
          shields += rules.decide(corner, b).side.answer == audit::Answer::yes;
    }
  }
  EXPECT_GT(shields, 100);
}

class Injected : public ::testing::Test {
 protected:
  Injected() : scene(rubble(1)) { scene.run(1.0); }

  /// Some record that acts, after the step.
  int acting_record() const {
    const Contacts& contacts = scene.model.contacts;
    for (int i = contacts.size() / 2; i < contacts.size(); ++i)
      if (contacts.active[i])
        return i;
    ADD_FAILURE() << "nothing acts";
    return 0;
  }
  /// Takes a record out of the list.
  void drop(int record) {
    Contacts rest;
    const Contacts& all = scene.model.contacts;
    rest.resize(all.size() - 1);
    for (int i = 0, k = 0; i < all.size(); ++i) {
      if (i == record)
        continue;
      rest.corner[k] = all.corner[i], rest.edge[k] = all.edge[i];
      rest.active[k++] = all.active[i];
    }
    scene.model.contacts = rest;
  }

  Scene scene;
};

TEST_F(Injected, MissedPairOfAnActingContact) {
  const AuditedStep step(scene);
  const int i = acting_record();
  const int corner = scene.model.contacts.corner[i],
            edge = scene.model.contacts.edge[i];
  drop(i);
  const Findings found = step.audit(scene);
  ASSERT_EQ(found.missed.size(), 1U);
  EXPECT_EQ(found.missed[0].corner, corner);
  EXPECT_EQ(found.missed[0].edge, edge);
  EXPECT_TRUE(found.missed[0].acts);
  ASSERT_EQ(found.wrong.size(), 1U);  // and so nothing acts where something should
  EXPECT_EQ(found.wrong[0].exact, edge);
}

// The list promises more than the contacts of this moment.
TEST_F(Injected, MissedPairThatDoesNotTouchYet) {
  const AuditedStep step(scene);
  const audit::ExactRules rules(step.before, 0.0);
  const Contacts& contacts = scene.model.contacts;
  const auto edge_block = [&](int i) {
    return step.before.corner_block[contacts.edge[i]];
  };
  const auto between = [&](int i) {
    const double d = rules.overlap(contacts.corner[i], contacts.edge[i]);
    const double along = rules.examine(contacts.corner[i], contacts.edge[i]).along;
    return !contacts.active[i] && d < -1e-4 && d > -0.05 && along > 0.0 &&
           along < 1.0 && rules.decide(contacts.corner[i], edge_block(i)).acting < 0;
  };
  int found_any = 0;
  for (int i = contacts.size() - 1; i >= 0 && found_any == 0; --i)
    if (between(i)) {
      const Contacts whole = contacts;
      const int corner = contacts.corner[i];
      drop(i);
      const Findings found = step.audit(scene);
      for (const auto& missed : found.missed) {
        EXPECT_EQ(missed.corner, corner);
        EXPECT_FALSE(missed.acts);
        ++found_any;
      }
      EXPECT_TRUE(found.wrong.empty());
      scene.model.contacts = whole;
    }
  EXPECT_EQ(found_any, 1);
}

TEST_F(Injected, ContactThatShouldNotAct) {
  const AuditedStep step(scene);
  const audit::ExactRules rules(step.before, 0.1);
  const Contacts& contacts = scene.model.contacts;
  int i = 0;
  const auto edge_block = [&] { return step.before.corner_block[contacts.edge[i]]; };
  while (rules.decide(contacts.corner[i], edge_block()).acting >= 0)
    ++i;
  scene.model.contacts.active[i] = 1;
  const Findings found = step.audit(scene);
  ASSERT_EQ(found.wrong.size(), 1U);
  EXPECT_EQ(found.wrong[0].corner, scene.model.contacts.corner[i]);
  EXPECT_EQ(found.wrong[0].acting, scene.model.contacts.edge[i]);
}

TEST_F(Injected, ContactThatShouldAct) {
  const AuditedStep step(scene);
  const int i = acting_record();
  scene.model.contacts.active[i] = 0;
  const Findings found = step.audit(scene);
  ASSERT_EQ(found.wrong.size(), 1U);
  EXPECT_EQ(found.wrong[0].acting, -1);
  EXPECT_EQ(found.wrong[0].exact, scene.model.contacts.edge[i]);
  EXPECT_TRUE(found.missed.empty());
}

// A contact put between blocks that lie 0.1 apart, and one on the far side of a block:
// neither depth is that of the two blocks' overlap.
TEST(Audit, ContactDeeperThanItsBlocksOverlap) {
  for (const auto& frame : {scenes::Frame{}, scenes::Frame{0.7, Vec2(3e3, -2e3)}}) {
    Scene scene(frame);
    scene.box(-2, -1, 4, 1, true);
    scene.box(-0.5, -0.01, 1, 1);
    scene.box(0.6, -0.01, 1, 1);
    scene.prepare();
    const AuditedStep step(scene);
    const Findings sound = step.audit(scene);
    EXPECT_TRUE(sound.deep.empty());
    EXPECT_EQ(sound.acting, 4);
    EXPECT_LT(sound.deepest.excess(), 1e-12);
    const auto found_with = [&](int corner, int edge) {
      Contacts& contacts = scene.model.contacts;
      const Contacts whole = contacts;
      int i = 0;
      while (contacts.active[i])
        ++i;
      contacts.corner[i] = corner, contacts.edge[i] = edge;
      contacts.active[i] = 1;
      const Findings found = step.audit(scene);
      contacts = whole;
      return found;
    };
    // corner 1 of the third block is 0.1 beyond side 3 of the second: nothing in common
    const Findings apart = found_with(8, 6);
    EXPECT_TRUE(apart.deep.empty());  // depth -0.1: not deep, but a wrong decision
    EXPECT_FALSE(apart.wrong.empty());
    // the same corner below its top edge, as deep as that block is high
    const Findings top = found_with(8, 5);
    ASSERT_EQ(top.deep.size(), 1U);
    EXPECT_NEAR(top.deep[0].overlap, 1.0, 1e-9);
    EXPECT_EQ(top.deep[0].common, 0.0);
    // on the floor, whose bottom edge is 0.99 from the corner and 0.01 are in common
    const Findings bottom = found_with(4, 3);
    ASSERT_EQ(bottom.deep.size(), 1U);
    EXPECT_NEAR(bottom.deep[0].overlap, 0.99, 1e-9);
    EXPECT_NEAR(bottom.deep[0].common, 0.01, 1e-9);
    EXPECT_EQ(bottom.deep[0].corner, 4);
    EXPECT_EQ(bottom.deep[0].edge, 3);
  }
}

// Bars laid across each other: no corner is inside the other block, so nothing acts,
// and rightly so by the rules. Only the overlap tells.
TEST(Audit, CrossedBarsOverlapBeyondTheirContacts) {
  Scene scene;
  scene.box(-2, -0.5, 4, 1, true);
  scene.box(-0.25, -2, 0.5, 4);
  scene.prepare();
  const Findings found = audited_step(scene);
  EXPECT_TRUE(found.sound());
  EXPECT_EQ(found.acting, 0);
  ASSERT_EQ(found.excess.size(), 1U);
  EXPECT_DOUBLE_EQ(found.excess[0].depth, 2.25);  // sideways, to the end of the bar
  EXPECT_DOUBLE_EQ(found.excess[0].area, 0.5);
  EXPECT_EQ(found.excess[0].explained, 0.0);
}

// A block resting on another overlaps by what its springs need: explained.
TEST(Audit, ABlockAtRestIsExplained) {
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
