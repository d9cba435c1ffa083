// What is certain as long as third blocks stay away from a joint: nobody can tell but
// by the time it takes.
#include "dynamics/third_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "dynamics/step.hpp"
#include "output/fields.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Scene;

/// Five courses of stones with slanted joints, some open, fall on a floor with a hole.
Model courses(bool rigid) {
  Scene scene;
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.4, s.damping = 0.2, s.contact_tolerance = 2e-3;
  scene.box(-1, -1, 3, 1, true);
  scene.box(2.9, -1, 4, 1, true);
  scene.box(-1, 0, 1, 4, true);
  scene.box(6, 0, 1, 4, true);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int row = 0; row < 5; ++row) {
    const double low = 0.5 * row + 0.01 * row, high = low + 0.5;
    double from = 0.0, from_above = 0.02;
    while (from < 5.0) {
      const double to = from + 0.8 + 0.3 * uniform(random);
      const double to_above = to + 0.05 * uniform(random);
      const double open = uniform(random) > 0 ? 0.01 : 0.0;
      scene.add({{from, low}, {from_above, high}, {to_above, high}, {to, low}});
      from = to + open, from_above = to_above + open;
    }
  }
  scene.gravity(0, -10);
  scene.prepare();
  return scene.model;
}

TEST(ThirdBlocks, ChangeNoBit) {
  for (const bool rigid : {true, false}) {
    Model kept = courses(rigid), anew = kept;
    dynamics::SearchBuffers buffers, forgetful;
    int most = 0;
    for (int i = 0; i < 6000; ++i) {
      if (i % 200 == 0)
        kept.search.left = anew.search.left = 0.0;  // a list is due after the step
      dynamics::step(kept, buffers);
      forgetful.groups.forget_decisions();
      dynamics::step(anew, forgetful);
      int count = 0;
      buffers.groups.thirds.each([&](const dynamics::ThirdBlock&) { ++count; });
      most = std::max(most, count);
    }
    EXPECT_GT(most, 20);  // are counted on
    EXPECT_GT(kept.search.updates, 20);
    EXPECT_EQ(fields(kept), fields(anew)) << (rigid ? "rigid" : "deformable");
  }
}

TEST(ThirdBlocks, HaveTheRoomOfTheirWindow) {
  dynamics::ThirdBlocks thirds;
  thirds.reserve(3);
  const auto groups = [&](int window) {
    std::vector<int> found;
    thirds.each(window, [&](const dynamics::ThirdBlock& third) {
      found.push_back(third.group);
    });
    return found;
  };
  int room = 0;
  while (thirds.add(
      1, {.group = room % 3, .pair = 8, .place = {}, .block = 0, .limit = 0}))
    ++room;
  EXPECT_GT(room, 16);
  EXPECT_TRUE(groups(0).empty() && groups(2).empty());
  EXPECT_TRUE(
      thirds.add(2, {.group = 7, .pair = 16, .place = {}, .block = 0, .limit = 0}));
  thirds.drop(1, 1);
  EXPECT_EQ(groups(1).size(), room - (room + 1) / 3);
  EXPECT_EQ(std::ranges::count(groups(1), 1), 0);
  EXPECT_EQ(groups(2), std::vector<int>{7});
  EXPECT_TRUE(
      thirds.add(1, {.group = 1, .pair = 8, .place = {}, .block = 0, .limit = 0}));
  thirds.forget();
  EXPECT_TRUE(groups(1).empty() && groups(2).empty());
  dynamics::ThirdsAway away;
  for (int k = 0; k < dynamics::ThirdsAway::most; ++k)
    EXPECT_TRUE(away.add({k, 1}) && away.add({k, 1}));
  EXPECT_EQ(away.count, dynamics::ThirdsAway::most);
  EXPECT_FALSE(away.add({0, 2}));
}

}  // namespace
}  // namespace blocks
