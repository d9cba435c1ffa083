// The audit finds faults that a test injects.
#include <gtest/gtest.h>

#include <algorithm>

#include "audit/audit.hpp"
#include "audit/moments.hpp"

namespace blocks {
namespace {

using audit::BlockPair;
using audit::Findings;
using scenes::Scene;
using testing::AuditedRun;

class InjectedFault : public ::testing::Test {
 protected:
  InjectedFault() : scene(testing::rubble(1)), run(scene.model) {
    scene.run(1.0);
    run.step();
  }
  std::vector<Contact>& contacts() { return scene.model.contacts; }
  /// Returns the contact in the middle of the list.
  Contact some_contact() { return contacts()[contacts().size() / 2]; }
  BlockPair blocks_of(const Contact& contact) { return pair_of(run.before, contact); }
  /// Removes a pair of blocks from the list.
  void drop(const BlockPair& pair) {
    auto& pairs = run.listed;
    pairs.erase(std::remove(pairs.begin(), pairs.end(), pair), pairs.end());
  }
  bool acts(const BlockPair& pair) {
    return std::any_of(
        contacts().begin(), contacts().end(),
        [&](const Contact& contact) { return blocks_of(contact) == pair; });
  }

  Scene scene;
  AuditedRun run;
};

TEST_F(InjectedFault, IsNotReportedInASoundStep) {
  const Findings found = run.audit();
  EXPECT_TRUE(found.sound());
  EXPECT_GT(found.acting, 10);
  EXPECT_EQ(found.acting, std::ssize(contacts()));
}

TEST_F(InjectedFault, IsReportedIfATouchingPairIsNotListed) {
  const BlockPair pair = blocks_of(some_contact());
  drop(pair);
  const Findings found = run.audit();
  EXPECT_EQ(found.missed, std::vector{pair});
  EXPECT_TRUE(found.wrong.empty());
}

// Some pairs of the list do not touch yet, but have to be listed.
TEST_F(InjectedFault, IsReportedIfAnApproachingPairIsNotListed) {
  const auto pairs = run.listed;
  int missed = 0;
  for (const BlockPair& pair : pairs) {
    if (acts(pair))
      continue;
    drop(pair);
    const Findings found = run.audit();
    run.listed = pairs;
    // The list may hold pairs that are not required.
    if (found.missed.empty())
      continue;
    EXPECT_EQ(found.missed, std::vector{pair});
    EXPECT_TRUE(found.wrong.empty());
    ++missed;
  }
  EXPECT_GT(missed, 0);
}

TEST_F(InjectedFault, IsReportedIfAContactActsAgainstTheRule) {
  const Contact contact = some_contact();
  const int corner = contact.corner, other = run.before.next[contact.edge];
  const BlockPair pair = blocks_of(contact);
  contacts().push_back({corner, other});
  const Findings found = run.audit();
  ASSERT_EQ(found.wrong.size(), 1U);
  const audit::WrongPair& wrong = found.wrong[0];
  EXPECT_EQ(BlockPair(wrong.first, wrong.second), pair);
  EXPECT_EQ(wrong.acting.size(), wrong.exact.size() + 1);
  EXPECT_TRUE(std::count(wrong.acting.begin(), wrong.acting.end(),
                         std::pair(corner, other)) == 1);
  EXPECT_TRUE(found.missed.empty());
}

// Block 8 is a wall, and the other block is far away from it.
TEST_F(InjectedFault, IsReportedIfAContactActsBetweenDistantBlocks) {
  const Blocks& blocks = run.before;
  const auto far = [&](int b) {
    return (blocks.centroid.col(b) - blocks.centroid.col(8)).norm() > 4.0 &&
           blocks.is_free(b);
  };
  int b = 0;
  while (!far(b))
    ++b;
  contacts().push_back({blocks.first_corner[b], blocks.first_corner[8]});
  const Findings found = run.audit();
  ASSERT_EQ(found.wrong.size(), 1U);
  EXPECT_EQ(found.wrong[0].acting.size(), 1U);
  EXPECT_TRUE(found.wrong[0].exact.empty());
}

TEST_F(InjectedFault, IsReportedIfAContactIsMissing) {
  const auto dropped = contacts().begin() + std::ssize(contacts()) / 2;
  const std::pair contact(dropped->corner, dropped->edge);
  contacts().erase(dropped);
  const Findings found = run.audit();
  ASSERT_EQ(found.wrong.size(), 1U);
  const auto &exact = found.wrong[0].exact, &program = found.wrong[0].acting;
  EXPECT_TRUE(std::count(exact.begin(), exact.end(), contact) == 1);
  EXPECT_TRUE(std::count(program.begin(), program.end(), contact) == 0);
  EXPECT_TRUE(found.missed.empty());
}

// All contacts of two crossed bars are removed. Only the overlap shows how deep they
// are.
TEST(LostContacts, LeaveTheOverlapUnexplained) {
  Scene scene;
  scene.box(-2, -0.5, 4, 1, true);
  scene.box(-0.25, -2, 0.5, 4);
  scene.prepare();
  AuditedRun run(scene.model);
  run.step();
  scene.model.contacts.clear();
  const Findings found = run.audit();
  EXPECT_EQ(found.acting, 0);
  EXPECT_EQ(found.wrong.size(), 1U);
  ASSERT_EQ(found.excess.size(), 1U);
  EXPECT_DOUBLE_EQ(found.excess[0].depth,
                   2.25);  // This is the distance to the end of the bar.
  EXPECT_DOUBLE_EQ(found.excess[0].area, 0.5);
  EXPECT_EQ(found.excess[0].explained, 0.0);
}

// Contacts are injected between blocks that are 0.1 apart and on the far side of a
// block. Their depths are not that of the overlap of the two blocks.
TEST(InjectedContact, IsReportedIfDeeperThanTheOverlap) {
  for (const auto& frame : {scenes::Frame{}, scenes::Frame{0.7, Vec2(3e3, -2e3)}}) {
    Scene scene(frame);
    scene.box(-2, -1, 4, 1, true);
    scene.box(-0.5, -0.01, 1, 1);
    scene.box(0.6, -0.01, 1, 1);
    scene.prepare();
    AuditedRun run(scene.model);
    run.step();
    const Findings sound = run.audit();
    EXPECT_TRUE(sound.deep.empty());
    EXPECT_EQ(sound.acting, 4);
    EXPECT_LT(sound.deepest.excess(), 1e-12);
    const auto found_with = [&](int corner, int edge) {
      const std::vector<Contact> whole = scene.model.contacts;
      scene.model.contacts.push_back({corner, edge});
      const Findings found = run.audit();
      scene.model.contacts = whole;
      return found;
    };
    // Corner 1 of the third block is 0.1 outside side 3 of the second. The contact is a
    // wrong decision, but not deep.
    const Findings apart = found_with(8, 6);
    EXPECT_TRUE(apart.deep.empty());
    EXPECT_FALSE(apart.wrong.empty());
    // The same corner is below the top edge, as deep as that block is high.
    const Findings top = found_with(8, 5);
    ASSERT_EQ(top.deep.size(), 1U);
    EXPECT_NEAR(top.deep[0].overlap, 1.0, 1e-9);
    EXPECT_EQ(top.deep[0].common, 0.0);
    // The corner is 0.99 from the bottom edge of the floor, and the blocks overlap by
    // 0.01.
    const Findings bottom = found_with(4, 3);
    ASSERT_EQ(bottom.deep.size(), 1U);
    EXPECT_NEAR(bottom.deep[0].overlap, 0.99, 1e-9);
    EXPECT_NEAR(bottom.deep[0].common, 0.01, 1e-9);
    EXPECT_EQ(bottom.deep[0].corner, 4);
    EXPECT_EQ(bottom.deep[0].edge, 3);
  }
}

// Boxes lean on a slanted symmetry plane. All corners behind it must act, and no other.
TEST(InjectedFaultAtAPlane, IsReported) {
  Scene scene({0.3, {5, 2}});
  scene.model.settings.damping = 0.3;
  scene.plane({0, 9}, {0, 0});
  scene.box(-1, -1, 8, 1, true);
  for (int row = 0; row < 3; ++row)
    scene.box(0.01, row, 1, 1);
  scene.gravity(-3, -10);
  scene.run(1.0);
  AuditedRun run(scene.model);
  run.step();
  const Findings sound = run.audit();
  EXPECT_TRUE(sound.sound());
  EXPECT_GT(sound.behind.depth, 0.0);
  std::vector<PlaneContact>& contacts = scene.model.plane_contacts;
  const auto acting = std::find_if(contacts.begin(), contacts.end(),
                                   [](const PlaneContact& one) { return one.active; });
  ASSERT_NE(acting, contacts.end());
  acting->active = false;
  Findings found = run.audit();
  EXPECT_FALSE(found.sound());
  ASSERT_EQ(found.wrong_at_planes.size(), 1U);
  EXPECT_EQ(found.wrong_at_planes[0].corner, acting->corner);
  EXPECT_FALSE(found.wrong_at_planes[0].acts);
  acting->active = true;
  // A corner in front of the plane acts.
  for (int c = 0; c < scene.model.blocks.corners(); ++c)
    if (std::none_of(contacts.begin(), contacts.end(),
                     [&](const PlaneContact& one) { return one.corner == c; }) &&
        scene.model.blocks.is_free(scene.model.blocks.corner_block[c])) {
      contacts.push_back({.plane = 0, .corner = c, .active = true});
      break;
    }
  found = run.audit();
  ASSERT_EQ(found.wrong_at_planes.size(), 1U);
  EXPECT_TRUE(found.wrong_at_planes[0].acts);
}

}  // namespace
}  // namespace blocks
