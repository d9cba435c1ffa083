// The scenes of the benchmark are what their names say.
#include <gtest/gtest.h>

#include <cmath>

#include "blocks_code.hpp"
#include "pile.hpp"
#include "wall.hpp"

namespace blocks {
namespace {

TEST(Scenes, WallHasAPowerOfTenOfBricksThatTouchAndFillIt) {
  for (const int power : {1, 2, 3}) {
    const Model wall = bench::wall_of_power(power);
    EXPECT_EQ(bench::free_blocks(wall), static_cast<int>(std::pow(10.0, power)));
    double area = 0.0;
    for (int b = 0; b < wall.blocks.size(); ++b)
      area += wall.blocks.is_free(b) ? wall.blocks.area[b] : 0.0;
    const double width = wall.settings.upper.x() - 2, top = wall.settings.upper.y() - 2;
    EXPECT_EQ(area, width * top);
  }
}

// A pile that has fallen through its floor would be fast to step.
TEST(Scenes, PileFallsTogetherAndStaysInItsBox) {
  bench::BlocksCode code(bench::loose_pile(60));
  const Model& model = code.model();
  const double width = model.settings.upper.x() - 2;
  double before = 0.0, after = 0.0;
  for (int b = 3; b < model.blocks.size(); ++b)
    before += model.blocks.centroid(1, b);
  while (model.time < 1.5)
    code.run(100);
  for (int b = 3; b < model.blocks.size(); ++b) {
    after += model.blocks.centroid(1, b);
    EXPECT_GT(model.blocks.centroid(0, b), 0.0);
    EXPECT_LT(model.blocks.centroid(0, b), width);
    EXPECT_GT(model.blocks.centroid(1, b), 0.0);
  }
  EXPECT_LT(after, 0.95 * before);
  EXPECT_GT(totals(code.model()).active_contacts, 60);
}

}  // namespace
}  // namespace blocks
