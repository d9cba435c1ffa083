#include "sweep/layer_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "run/run.hpp"
#include "tools/program.hpp"

namespace blocks::sweep {
namespace {

using nlohmann::ordered_json;

/// Builds the blocks of decks.
class LayerMeasuresOfDecks : public ::testing::Test {
 protected:
  run::CheckedDeck build(const std::string& cards, std::uint64_t seed = 1) const {
    folder_.write("layers.deck",
                  "START, 1000, 4\nLAYERS\nXLIMITS, -100, 200\n"
                  "YLIMITS, -100, 200\nBOXES, 300, 300, 0.01\n"
                  "STIFF, 1.E9, 1.E9\nFRACTION, .05\n"
                  "MATERIAL, 1, 1.E10, 4.E9, 2500\nSEED, 1\nRIGID\nEND\n" +
                      cards + "GRAVITY, 0, -10\nCYCLE, 1\nSTOP\n");
    run::RunOptions options;
    options.deck = (folder_ / "layers.deck").string();
    options.seed = seed;
    run::CheckedDeck deck = run::build_checked(options);
    EXPECT_EQ(deck.code, run::done);
    return deck;
  }
  LayerMeasures measure(const std::string& cards, std::uint64_t seed = 1) const {
    const run::CheckedDeck deck = build(cards, seed);
    return measure_layers(deck.model, deck.certificate);
  }

 private:
  testing::TemporaryFolder folder_;
};

constexpr double rounding = 1e-12;

// Four squares in a row below five blocks: 3 + 4 upright joints of length 1 and a level
// joint of length 4 over an area of 8. Each of the 3 + 4 ends of joints on the level
// line is inside a side.
TEST_F(LayerMeasuresOfDecks, BricksInBond) {
  const LayerMeasures bricks = measure("LAYER, -4, 1, 0,0, 0,1, 4,1, 4,0\n"
                                       "LAYER, -5, 1, 0,1, 0,2, 4,2, 4,1\n");
  EXPECT_EQ(bricks.layers, 2);
  EXPECT_EQ(bricks.blocks, 9);
  EXPECT_NEAR(bricks.p21, 11.0 / 8.0, rounding);
  EXPECT_EQ(bricks.t_vertices, 7);
  EXPECT_EQ(bricks.x_vertices, 0);
  EXPECT_TRUE(bricks.certificate);
  EXPECT_EQ(bricks.gaps, 0);
  EXPECT_NEAR(bricks.aspect.max, 1.25, rounding);
  EXPECT_NEAR(bricks.aspect.min, 1.0, rounding);
  EXPECT_NEAR(bricks.shortest_side.min, 0.8, rounding);
  EXPECT_NEAR(bricks.smallest_angle.mean, 90.0, 1e-9);
  EXPECT_NEAR(bricks.area.mean, 8.0 / 9.0, rounding);
  EXPECT_NEAR(bricks.width.mean, 8.0 / 9.0, rounding);
}

// On a slanted line the corners of the two layers are rounded to different doubles.
TEST_F(LayerMeasuresOfDecks, BricksWithContinuousJointsOnASlantedLine) {
  const LayerMeasures bricks = measure("LAYER, -7, 1, 0,0, 0,1, 7,3.3, 7,2.3\n"
                                       "LAYER, -7, 1, 0,1, 0,2, 7,4.3, 7,3.3\n");
  EXPECT_EQ(bricks.t_vertices, 0);
  EXPECT_EQ(bricks.x_vertices, 6);
  EXPECT_NEAR(bricks.p21, (12.0 + std::hypot(7.0, 2.3)) / 14.0, rounding);
  EXPECT_NEAR(bricks.width.min, std::hypot(1.0, 2.3 / 7.0), rounding);
  EXPECT_NEAR(bricks.width.max, bricks.width.min, rounding);
}

TEST_F(LayerMeasuresOfDecks, BlocksOfOtherCardsCountOnlyWithoutLayers) {
  const std::string floor = "CREATE, 4, 1, 1\n-1, -1, 5, 5\n-1, 0.25, 0.25, -1\n";
  const LayerMeasures alone = measure(floor);
  EXPECT_EQ(alone.blocks, 1);
  EXPECT_EQ(alone.p21, 0.0);
  EXPECT_EQ(to_json(alone)["width"]["mean"], nullptr);
  EXPECT_EQ(to_json(alone)["area"]["sd"], nullptr);
  // The layer overlaps the floor, which is not part of it.
  const LayerMeasures both = measure(floor + "LAYER, -4, 1, 0,0, 0,1, 4,1, 4,0\n");
  EXPECT_EQ(both.blocks, 4);
  EXPECT_NEAR(both.p21, 0.75, rounding);
  EXPECT_EQ(both.t_vertices, 0);
  EXPECT_FALSE(both.certificate);
  EXPECT_EQ(both.overlaps, 4);
}

TEST_F(LayerMeasuresOfDecks, CountsWhatMergeAbsorbedAndWhatWasRedrawn) {
  const LayerMeasures random =
      measure("ORIENT, -60, 60\nMERGE, 0.5\n"
              "LAYER, -100, 1, 0,0, 0,1, 100,1, 100,0, RANDOM\n");
  EXPECT_GT(random.absorbed, 5);
  EXPECT_EQ(random.blocks + random.absorbed, 100);
  EXPECT_GT(random.sides_redrawn, 5);
  EXPECT_GE(random.angles_redrawn, random.sides_redrawn);
  EXPECT_LT(random.smallest_angle.min, 60.0);
  const ordered_json json = to_json(random);
  EXPECT_EQ(json["absorbed"], random.absorbed);
  EXPECT_EQ(json["aspect"]["p95"], random.aspect.p95);
  EXPECT_EQ(json["certificate"], true);
}

// The widths of a layer add up to its length S. So their mean is S / n in each layer,
// and any two of n exchangeable widths have the correlation -1 / (n - 1).
TEST_F(LayerMeasuresOfDecks, WidthsOfALayerHaveItsMeanAndCorrelation) {
  constexpr int n = 5, layers = 3000;
  const double length = std::hypot(6.0, 0.5);
  std::vector<double> first, second;
  for (int seed = 1; seed <= layers; ++seed) {
    const run::CheckedDeck deck =
        build("ORIENT, -10, 10\nLAYER, -5, 1, 0,0, 0,1, 6,1.6, 6,0.4, RANDOM\n",
              static_cast<std::uint64_t>(seed));
    const auto widths = widths_of_layer(deck.model.blocks, deck.model.layers.front());
    ASSERT_EQ(widths.size(), std::size_t{n});
    EXPECT_NEAR(std::accumulate(widths.begin(), widths.end(), 0.0) / n, length / n,
                4e-16 * length);
    first.push_back(widths[0]);
    second.push_back(widths[1]);
  }
  const Spread a = spread_of(first), b = spread_of(second);
  double products = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
    products += (first[i] - a.mean) * (second[i] - b.mean);
  // Its standard error is about 0.017.
  EXPECT_NEAR(products / (layers - 1) / (a.sd * b.sd), -1.0 / (n - 1), 0.06);
  EXPECT_NEAR(a.mean, length / n, 4.0 * a.sd / std::sqrt(layers));
}

TEST(Spread, UsesOrderStatistics) {
  std::vector<double> values(21);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(21 - i);
  const Spread spread = spread_of(values);
  EXPECT_EQ(spread.min, 1.0);
  EXPECT_EQ(spread.p5, 2.0);
  EXPECT_EQ(spread.p50, 11.0);
  EXPECT_EQ(spread.p95, 20.0);
  EXPECT_EQ(spread.max, 21.0);
  EXPECT_EQ(spread.mean, 11.0);
  EXPECT_DOUBLE_EQ(spread.sd, std::sqrt(38.5));
  EXPECT_TRUE(std::isnan(spread_of({2.0}).sd));
}

}  // namespace
}  // namespace blocks::sweep
