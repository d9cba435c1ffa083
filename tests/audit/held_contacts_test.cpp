// The audit knows that the laws of joints hold contacts outside the contact rule.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include "model/compression.hpp"

namespace blocks::audit {
namespace {

/// A fixed floor and a box 1 wide and 1 high on it, `above` higher than flush. The
/// corners of the box are 4 (bottom left), 5, 6, 7 (bottom right); the upper edge of
/// the floor is 1.
struct OnFloor {
  Model model;
  std::vector<HeldContact> held;

  explicit OnFloor(double above) {
    const double y = above;
    model.blocks.append(
        {{{{-2, -1}, {-2, 0}, {2, 0}, {2, -1}}, 1, 1.0, Fixity::by_user, 0},
         {{{0, y}, {0, y + 1}, {1, y + 1}, {1, y}}, 1, 1.0, Fixity::free, 0}});
  }
  /// Adds a contact that acted, and its state before the step.
  void acts(int corner, int edge, bool bonded, double offset) {
    model.contacts.push_back({corner, edge, 0, 0, 0, 0, 0});
    if (bonded || offset != 0.0)
      held.push_back({corner, edge, bonded, offset});
  }
  Findings judged() const {
    return audit({model.blocks,
                  model.contacts,
                  model.settings,
                  0.0,
                  {{0, 1}},
                  {},
                  held,
                  model.law_states});
  }
};

TEST(HeldContacts, ABondActsThoughTheBlocksAreApart) {
  OnFloor scene(0.01);
  scene.acts(4, 1, true, 0.0);
  scene.acts(7, 1, true, 0.0);
  EXPECT_TRUE(scene.judged().sound());
  scene.model.contacts.pop_back();  // a bond must act
  EXPECT_EQ(scene.judged().wrong.size(), 1u);
}

TEST(HeldContacts, WithoutABondTheRuleDecides) {
  OnFloor scene(0.01);
  scene.acts(4, 1, false, 0.0);
  const Findings found = scene.judged();
  ASSERT_EQ(found.wrong.size(), 1u);
  EXPECT_TRUE(found.wrong[0].exact.empty());
}

TEST(HeldContacts, DilationHoldsAContactAsFarAsItReaches) {
  OnFloor scene(0.01);
  scene.acts(4, 1, false, 0.02);
  scene.acts(7, 1, false, 0.02);
  EXPECT_TRUE(scene.judged().sound());
  for (HeldContact& one : scene.held)
    one.offset = 0.005;
  EXPECT_EQ(scene.judged().wrong.size(), 1u);
  scene.model.contacts.clear();
  EXPECT_TRUE(scene.judged().sound());
  for (HeldContact& one : scene.held)
    one.offset = 0.02;
  EXPECT_EQ(scene.judged().wrong.size(), 1u) << "they must act";
}

// A corner that is bonded to an edge of a block acts on no other edge of that block.
TEST(HeldContacts, ABondedCornerLeavesTheContactsOfTheRule) {
  OnFloor scene(-0.01);
  scene.acts(4, 1, false, 0.0);
  scene.acts(7, 1, false, 0.0);
  EXPECT_TRUE(scene.judged().sound()) << "both are contacts of the rule";
  scene.held.push_back({7, 2, true, 0.0});
  EXPECT_EQ(scene.judged().wrong.size(), 1u);
  scene.model.contacts[1].edge = 2;
  EXPECT_TRUE(scene.judged().sound());
}

TEST(HeldContacts, ArePressedInByTheirOverlap) {
  OnFloor scene(-0.01);
  scene.acts(4, 1, false, 0.0);
  scene.acts(7, 1, false, 0.0);
  scene.model.contacts[0].normal_elastic = 10.0;
  scene.model.contacts[0].overlap = 0.003;
  LawState state;
  state.law = 1, state.stiffness = 1e3;
  scene.model.law_states = {state, LawState{}};
  const auto pressed = [&] {
    return compression(scene.model.settings, scene.model.contacts,
                       scene.model.law_states, 0);
  };
  EXPECT_EQ(pressed(), 0.003) << "its force depends on more than the compression";
  scene.model.law_states.clear();
  EXPECT_EQ(pressed(), 10.0 / scene.model.settings.normal_stiffness);
}

}  // namespace
}  // namespace blocks::audit
