// The warning of a contact whose depth no overlap explains.
#include "run/watch/deep_contact.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "run/watch/motion_watch.hpp"
#include "tools/rectangle.hpp"

namespace blocks::run {
namespace {

using testing::rectangle;

/// Two squares that overlap at a corner by `overlap`. The corner of the second one acts
/// on the bottom of the first one, which it is almost as far above as the square is
/// high. More blocks may follow.
Model phantom(double overlap, std::vector<NewBlock> more = {}) {
  std::vector<NewBlock> made = {rectangle(0.0, 0.0, 1.0, 1.0),
                                rectangle(1.0 - overlap, 1.0 - overlap, 1.0, 1.0)};
  made.insert(made.end(), more.begin(), more.end());
  Model model;
  model.blocks.append(made);
  model.contacts.push_back({.corner = 4, .edge = 3, .overlap = 1.0 - overlap});
  return model;
}

TEST(DeepContact, IsFarDeeperThanItsBlocksOverlap) {
  const auto found = find_deep_contact(phantom(0.01));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->corner, 4);
  EXPECT_EQ(found->edge, 3);
  EXPECT_DOUBLE_EQ(found->overlap, 0.99);
}

TEST(DeepContact, MayBeTwiceAsDeepAsTheOverlap) {
  EXPECT_TRUE(find_deep_contact(phantom(0.333)));
  EXPECT_FALSE(find_deep_contact(phantom(0.334)));
}

// A third block beside the first square overlaps the second one by half of the depth.
TEST(DeepContact, MayBeExplainedByAThirdBlockNearBoth) {
  EXPECT_TRUE(find_deep_contact(phantom(0.01, {rectangle(1.01, 0.0, 1.0, 1.47)})));
  EXPECT_FALSE(find_deep_contact(phantom(0.01, {rectangle(1.01, 0.0, 1.0, 1.8)})));
  EXPECT_TRUE(find_deep_contact(phantom(0.01, {rectangle(1.49, 0.0, 1.0, 1.8)})));
}

TEST(DeepContact, IsNotOneThatALawHolds) {
  Model model = phantom(0.01);
  model.law_states.resize(1);
  EXPECT_TRUE(find_deep_contact(model));
  model.law_states[0].bonded = true;
  EXPECT_FALSE(find_deep_contact(model));
}

TEST(DeepContact, IsReportedOnceWithTheCommandThatExplainsIt) {
  Model model = phantom(0.01);
  MotionWatch watch(model);
  EXPECT_TRUE(watch.is_state_check_due(model));
  EXPECT_EQ(watch.check_state(model),
            std::vector<std::string>{
                "corner 1 of block 2 is 0.99 below edge 4 of block 1 at time 0, more "
                "than twice as deep as any overlap there explains: `blocks why FILE "
                "--time 0 --block 1 --block 2` tells why it acts"});
  EXPECT_TRUE(watch.reported().deep);
  EXPECT_TRUE(watch.check_state(model).empty());
  EXPECT_FALSE(watch.is_state_check_due(model));
  EXPECT_FALSE(MotionWatch(model, watch.reported()).is_state_check_due(model));
}

}  // namespace
}  // namespace blocks::run
