// The second judge of contacts is judged itself: on places where the answer is known.
#include "audit/exact_decision.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "audit/moments.hpp"

namespace blocks {
namespace {

using audit::Answer;
using audit::ExactRules;
using scenes::Scene;

/// A unit square with its lower left corner (corner 1 of the second block) at p.
Scene square_over_floor(const Vec2& p) {
  Scene scene;
  scene.box(0, -1, 4, 1, true);
  scene.box(p.x(), p.y(), 1, 1);
  return scene;
}

// One unit in the last place decides: nothing is rounded.
TEST(ExactDecision, OverlapIsASignNotANumber) {
  const double below = -0x1p-1074;
  const auto decide = [](double y) {
    const Scene scene = square_over_floor({1, y});
    return ExactRules(scene.model.blocks, 0.2).decide(4, 0);
  };
  EXPECT_EQ(decide(0.0).acting, -1);
  EXPECT_EQ(decide(0.0).nearest, 1);  // the top edge, from corner 2 of the floor
  EXPECT_EQ(decide(below).acting, 1);
  EXPECT_EQ(decide(-below).acting, -1);
}

TEST(ExactDecision, NumbersOfOneEdge) {
  const Scene scene = square_over_floor({1, -0.25});
  const audit::EdgeStory edge = ExactRules(scene.model.blocks, 0.2).examine(4, 1);
  EXPECT_EQ(edge.overlap, 0.25);
  EXPECT_EQ(edge.length, 4.0);
  EXPECT_EQ(edge.depth_limit, 0.5);
  EXPECT_EQ(edge.along, 0.25);
  EXPECT_EQ(edge.tangent_before, 0.0);  // along the floor
  EXPECT_EQ(edge.tangent_after, 1.0);
  EXPECT_TRUE(edge.admissible);
}

// (20) turns over at ten degrees: judged by sines of angles 1e-12 to either side.
TEST(ExactDecision, TangentsTurnOverAtTenDegrees) {
  constexpr double degree = 3.14159265358979323846 / 180;
  for (const double off : {-1e-12, 1e-12}) {
    const double angle = 10 * degree + off;
    Scene scene;
    scene.box(0, -1, 4, 1, true);
    const Vec2 p(2, -0.01);
    scene.add({p, p + Vec2(0, 1), p + Vec2(std::cos(angle), -std::sin(angle))});
    const audit::EdgeStory edge = ExactRules(scene.model.blocks, 0.2).examine(4, 1);
    EXPECT_EQ(edge.facing_before, off < 0) << edge.tangent_before;
    EXPECT_TRUE(edge.facing_after);
  }
}

// Equally deep below two edges of a corner: the first of the block acts.
TEST(ExactDecision, TiesGoToTheFirstEdge) {
  Scene scene;
  scene.box(0, 0, 4, 4, true);
  const Vec2 p(3.75, 3.75);  // beside corner 3, between edges 2 and 3
  scene.add({p, p + Vec2(0, 4), p + Vec2(4, 4), p + Vec2(4, 0)});
  const auto decision = ExactRules(scene.model.blocks, 0.2).decide(4, 0);
  EXPECT_EQ(decision.nearest, 1);
  EXPECT_EQ(decision.next, 2);
  EXPECT_EQ(decision.acting, 1);
  EXPECT_FALSE(decision.allows(2));
}

// A box slides over the joint of two floor boxes: the joint's side is nearest, but the
// second box shields it. Alone, the first box would act with its side.
TEST(ExactDecision, AClosedJointIsShielded) {
  for (const bool closed : {true, false}) {
    Scene scene;
    scene.box(0, -1, 1, 1, true);
    if (closed)
      scene.box(1, -1, 1, 1, true);
    scene.box(1 - 1e-5, -1e-3, 1, 1);
    const int corner = closed ? 8 : 4;
    const auto decision = ExactRules(scene.model.blocks, 0.2).decide(corner, 0);
    EXPECT_EQ(decision.nearest, 2);  // the right side
    EXPECT_EQ(decision.next, 1);     // the top
    EXPECT_EQ(decision.side.answer, closed ? Answer::yes : Answer::no);
    EXPECT_EQ(decision.acting, closed ? 1 : 2);
    EXPECT_EQ(decision.side.third, closed ? 1 : -1);
  }
}

// Rules know no unit and no origin: what is decided for rubble is decided for its
// image, scaled by a power of two.
TEST(ExactDecision, ScalingByAPowerOfTwoChangesNothing) {
  Scene scene = testing::rubble(4);
  scene.run(0.5);
  Blocks large = scene.model.blocks;
  large.corner *= 0x1p40, large.centroid *= 0x1p40;
  const ExactRules rules(scene.model.blocks, 0.2), scaled(large, 0.2 * 0x1p40);
  int acting = 0;
  for (int c = 0; c < large.corners(); ++c)
    for (const int b : rules.near(c)) {
      const auto one = rules.decide(c, b), other = scaled.decide(c, b);
      ASSERT_EQ(one.acting, other.acting);
      ASSERT_EQ(one.nearest, other.nearest);
      acting += one.acting >= 0;
    }
  EXPECT_GT(acting, 10);
}

}  // namespace
}  // namespace blocks
