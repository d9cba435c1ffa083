// The scenes of the benchmark move as their names say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "blocks_code.hpp"
#include "pile.hpp"
#include "scenes.hpp"
#include "wall.hpp"

namespace blocks {
namespace {

using ContactSet = std::set<std::pair<int, int>>;  ///< corners and edges

ContactSet acting(const Model& model) {
  ContactSet found;
  for (const Contact& contact : model.contacts)
    found.emplace(contact.corner, contact.edge);
  return found;
}

/// Makes a step and returns the share of contacts that begin or end in it.
double changing_contacts(bench::BlocksCode& code) {
  const ContactSet before = acting(code.model());
  code.run(1);
  const ContactSet after = acting(code.model());
  ContactSet changed;
  std::set_symmetric_difference(before.begin(), before.end(), after.begin(),
                                after.end(), std::inserter(changed, changed.end()));
  return static_cast<double>(changed.size()) / static_cast<double>(before.size());
}

TEST(Scenes, WallIsFilledByAPowerOfTenOfBricks) {
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

// A pile that falls through its floor would need little time per step.
TEST(Scenes, PileSettlesInItsBox) {
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

TEST(Scenes, ChatteringWallKeepsChangingContactsUnlikeTheCalmWall) {
  for (const bool rigid : {true, false}) {
    bench::BlocksCode calm(bench::advanced(bench::calm_wall(2), rigid));
    bench::BlocksCode chatter(bench::advanced(bench::chattering_wall(2), rigid));
    EXPECT_GT(changing_contacts(chatter), 0.1);
    calm.run(3000);
    chatter.run(3000);
    EXPECT_LT(changing_contacts(calm), 0.02);
    EXPECT_GT(changing_contacts(chatter), 0.1);
  }
}

// Rock at rest hardly moves, the receding wall lets it creep, and without the wall the
// front falls.
TEST(Scenes, CutRockMovesAsItsSupportLetsIt) {
  for (const bench::Cut cut : {bench::Cut::two_sets, bench::Cut::voronoi}) {
    const auto mean_speed = [&](bench::Support support) {
      const Model model = bench::advanced(bench::rock_scene(cut, 150, support), true);
      double sum = 0.0;
      for (int b = 0; b < model.blocks.size(); ++b)
        if (model.blocks.is_free(b))
          sum += model.blocks.velocity.col(b).norm();
      return sum / bench::free_blocks(model);
    };
    const double at_rest = mean_speed(bench::Support::walls),
                 creeping = mean_speed(bench::Support::receding_wall);
    EXPECT_LT(at_rest, 0.001);
    EXPECT_GT(creeping, 2.0 * at_rest);
    EXPECT_LT(creeping, 0.05);
    EXPECT_GT(mean_speed(bench::Support::one_wall), 0.05);
  }
}

TEST(Scenes, LawsOfRockHaveTheFrictionOfTheOthers) {
  const Model with = bench::rock_with_laws(bench::Cut::voronoi, 150).start;
  ASSERT_EQ(with.settings.joint_laws.size(), 2U);
  for (const auto& [id, law] : with.settings.joint_laws)
    EXPECT_EQ(law.friction, with.settings.friction);
}

TEST(Scenes, LayersOfTheSlopeSlideOnEachOther) {
  const bench::Scene scene = bench::slope_scene();
  bench::BlocksCode code(bench::advanced(scene, true));
  EXPECT_EQ(bench::free_blocks(code.model()), 1000);
  while (code.model().time < 0.1)
    code.run(100);
  const Blocks& blocks = code.model().blocks;
  double speed_below = 0.0;
  const int first = blocks.size() - 1000;
  for (int layer = 0, b = first; layer < 4; ++layer) {
    const int bricks = 280 - 20 * layer;
    const double speed = blocks.velocity.middleCols(b, bricks).colwise().norm().mean();
    EXPECT_GT(speed, speed_below + 0.8) << layer;
    speed_below = speed;
    b += bricks;
  }
}

TEST(Scenes, DecksMoveDuringTheMeasuredTime) {
  for (const bench::Scene& scene : {bench::crater_scene(), bench::subsidence_scene()}) {
    bench::BlocksCode code(bench::advanced(scene, true));
    const double end = code.model().time + scene.window;
    while (code.model().time < end)
      code.run(100);
    EXPECT_GT(totals(code.model()).fastest, 1.0) << scene.name;
  }
}

}  // namespace
}  // namespace blocks
