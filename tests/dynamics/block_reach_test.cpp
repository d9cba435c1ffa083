// Which edges of a block are found for a corner, against what the list promises, said
// plainly.
#include "dynamics/block_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

using dynamics::BlockReach;
using dynamics::Record;

/// Edges that the corner is not beyond; of a convex block all of these where it is
/// inside of every edge, and where it is outside of one those beside that one whose
/// strip it is in.
std::vector<Record> expected(const BlockReach& reach, const Vec2& at, int c) {
  std::vector<Record> found;
  std::vector<int> outside;
  const int count = static_cast<int>(reach.edges.size());
  for (int e = 0; e < count; ++e)
    if (reach.edges[e].overlap(at) < -reach.edges[e].near)
      outside.push_back(e);
  for (int e = 0; e < count; ++e) {
    const dynamics::Reach& edge = reach.edges[e];
    const double overlap = edge.overlap(at);
    bool listed = overlap >= -edge.near && overlap <= edge.depth + edge.near;
    if (reach.convex && !outside.empty()) {
      const int apart = (e - outside[0] + count) % count;
      listed = listed && outside.size() == 1 && (apart == 1 || apart == count - 1) &&
               edge.between(at);
    }
    if (listed)
      found.push_back({c, reach.first + e});
  }
  return found;
}

TEST(BlockReach, FindsTheEdgesThatCouldAct) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(-1, 1);
  long inside = 0, beside = 0, none = 0;
  int convex = 0, notched = 0;
  for (const int corners : {3, 4, 5, 8, 63, 64, 65, 130, 200}) {
    for (const bool star : {false, true}) {
      scenes::Scene scene;
      geometry::Polygon outline;
      for (int k = 0; k < corners; ++k) {
        const double angle = -6.283185307179586 * k / corners;
        const double radius = star && k % 2 == 1 ? 0.6 : 1.0;
        outline.push_back(radius * Vec2(std::cos(angle), 0.7 * std::sin(angle)));
      }
      const int b = scene.add(outline);
      BlockReach reach;
      reach.set(scene.model.blocks, b, 0.02);
      (reach.convex ? convex : notched) += 1;
      for (int i = 0; i < 400; ++i) {
        const Vec2 at = 1.4 * Vec2(uniform(random), uniform(random));
        std::vector<Record> found;
        reach.find(at, 7, found);
        EXPECT_EQ(found, expected(reach, at, 7)) << corners << " " << at.transpose();
        (found.empty() ? none : found.size() > 2 ? inside : beside) += 1;
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(beside, 50);
  EXPECT_GT(none, 1000);
  EXPECT_GE(convex, 9);
  EXPECT_GE(notched, 5);
}

}  // namespace
}  // namespace blocks
