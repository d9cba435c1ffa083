// Blocks that are exported and imported have the same bits, in every format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "deck/mesh/mesh_readers.hpp"
#include "exchange/block_record.hpp"
#include "exchange/geojson_reader.hpp"
#include "exchange/mesh_writer.hpp"
#include "exchange/soundness.hpp"
#include "exchange/wkt_reader.hpp"
#include "geometry/layer.hpp"
#include "geometry/polygon.hpp"
#include "tools/program.hpp"

namespace blocks::exchange {
namespace {

using testing::Outcome;
using testing::TemporaryFolder;

bool same_bits(const geometry::Polygon& a, const geometry::Polygon& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const geometry::Vec2& p, const geometry::Vec2& q) {
                      return bits(p.x()) == bits(q.x()) && bits(p.y()) == bits(q.y());
                    });
}

/// Returns a random layer of any size, near the origin or far from it.
std::vector<BlockRecord> random_layer(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double scale = std::pow(10.0, std::floor(8 * part(random)) - 4);
  const double offset = seed % 3 == 0 ? 0.0 : 1e5 * scale * part(random);
  const auto decimal = [&](double x) {
    return *geometry::Decimal::parse(fmt::format("{}", offset + scale * x));
  };
  geometry::LayerRequest request;
  request.count = 12;
  request.spacing = geometry::Spacing::random;
  request.angle_min = *geometry::Decimal::parse("-15");
  request.angle_max = *geometry::Decimal::parse("15");
  const double tilt = part(random);
  request.corners = {geometry::DecimalPoint{decimal(0), decimal(0)},
                     {decimal(0.1 * tilt), decimal(1)},
                     {decimal(12), decimal(1 + tilt)},
                     {decimal(12.3), decimal(0.3 * tilt)}};
  request.stream = {seed, 1};
  const geometry::Layer layer = geometry::cut_layer(request);
  std::vector<BlockRecord> blocks;
  for (const std::vector<int>& cell : layer.mesh.cells) {
    BlockRecord block;
    block.number = static_cast<int>(blocks.size()) + 1;
    block.material = 1 + block.number % 3;
    for (const int vertex : cell)
      block.outline.push_back(layer.mesh.vertices[vertex]);
    blocks.push_back(block);
  }
  return blocks;
}

/// Requires the same outlines after the steps of `blocks import`. Outlines are made
/// clockwise with the same corner 1 and go through the text form of READ9.
void expect_back(OutlineFile file, const std::vector<BlockRecord>& blocks) {
  ASSERT_TRUE(file.messages.empty()) << file.messages[0].text;
  ASSERT_EQ(file.outlines.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Outline& outline = file.outlines[b];
    EXPECT_TRUE(geometry::check_outline(outline.corners)
                    .anticlockwise);  // RFC 7946 requires it.
    reverse(outline);
    outline.material = blocks[b].material;
    EXPECT_TRUE(same_bits(outline.corners, blocks[b].outline));
  }
  const auto mesh = deck::parse_mesh("mesh", write_mesh(file.outlines, "law"));
  ASSERT_EQ(mesh.blocks.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    EXPECT_TRUE(same_bits(mesh.blocks[b].outline, blocks[b].outline));
}

TEST(RoundTrip, KeepsTheBitsOfRandomLayers) {
  std::size_t corners = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<BlockRecord> blocks = random_layer(seed);
    for (const BlockRecord& block : blocks)
      corners += block.outline.size();
    expect_back(read_geojson(write_geojson(blocks)), blocks);
    expect_back(read_wkt(write_wkt(blocks)), blocks);
    const auto gmsh = deck::parse_mesh("mesh", write_gmsh(blocks));
    ASSERT_EQ(gmsh.blocks.size(), blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      EXPECT_TRUE(same_bits(gmsh.blocks[b].outline, blocks[b].outline));
      EXPECT_EQ(gmsh.blocks[b].material, blocks[b].material);
    }
    if (HasFailure())
      return;
  }
  EXPECT_GT(corners, 5000u);
}

// The doubles are the smallest, the largest, minus zero, and ties of decimals.
TEST(RoundTrip, KeepsTheBitsOfSpecialDoubles) {
  const std::vector<double> awkward = {0.0,
                                       -0.0,
                                       5e-324,
                                       2.2250738585072014e-308,
                                       1.7976931348623157e308,
                                       0.1,
                                       1.0 / 3.0,
                                       9007199254740993.0,
                                       1e22,
                                       1e23,
                                       -123456789.123456789};
  std::vector<BlockRecord> blocks(1);
  for (const double x : awkward)
    for (const double y : awkward)
      blocks[0].outline.emplace_back(x, y);
  for (OutlineFile file :
       {read_geojson(write_geojson(blocks)), read_wkt(write_wkt(blocks))}) {
    ASSERT_EQ(file.outlines.size(), 1u);
    reverse(file.outlines[0]);
    EXPECT_TRUE(same_bits(file.outlines[0].corners, blocks[0].outline));
  }
}

// A double would lose some of these digits.
TEST(RoundTrip, KeepsTheDigitsOfTheFile) {
  const std::string geojson =
      R"({"coordinates": [[[0.10, -0], [1.0000000000000000001, 0E0],)"
      R"( [1.5e+0, 2], [0.10, -0]]], "type": "Polygon"})";
  const OutlineFile file = read_geojson(geojson);
  ASSERT_EQ(file.outlines.size(), 1u);
  EXPECT_EQ(file.outlines[0].written,
            (std::vector<WrittenCorner>{
                {"0.10", "-0"}, {"1.0000000000000000001", "0E0"}, {"1.5e+0", "2"}}));
  const OutlineFile wkt = read_wkt("polygon((+.5 1.,2 1E0 , 3. 4,0.5 1))");
  ASSERT_EQ(wkt.outlines.size(), 1u);
  EXPECT_EQ(wkt.outlines[0].written,
            (std::vector<WrittenCorner>{{"+.5", "1."}, {"2", "1E0"}, {"3.", "4"}}));
}

constexpr const char* deck_of_layers =
    "START, 200, 6\nLAYERS\nXLIMITS, -5, 25\nYLIMITS, -5, 10\nBOXES, 20, 10, 0.1\n"
    "FRACTION, 0.02\nMATERIAL, 1, 1.E9, 4.E8, 2000\nMATERIAL, 7, 1.E9, 4.E8, 2500\n"
    "SEED, {}\nRIGID\nEND\n"
    "CREATE, 4, 1, 1\n-1, -1, 21, 21\n-1, 0, 0, -1\n"
    "ORIENT, -15, 15\n"
    "LAYER, -20, 7, 0, 0, 0, 1.1, 20, 1.3, 20, 0, RANDOM\n"
    "LAYER, -16, 1, 0, 1.5, 0, 2.3, 20, 2.7, 20, 1.7, RANDOM\nSTOP\n";

// The second export is equal to the first one, including fixed blocks and materials. So
// READ9 reads the same bits.
TEST(RoundTrip, GivesTheSameFileAgain) {
  for (const int seed : {1, 2, 3}) {
    const TemporaryFolder folder;
    folder.write("a.deck", fmt::format(deck_of_layers, seed));
    const auto run = [&](const std::string& arguments) {
      const Outcome outcome = testing::blocks(arguments, folder.path());
      EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    };
    run("export a.deck -o a.geojson");
    run("import a.geojson -o b.mesh.txt --deck");
    run("check b.deck");
    run("export b.deck -o b.geojson");
    EXPECT_EQ(testing::slurp(folder / "a.geojson"),
              testing::slurp(folder / "b.geojson"));
    run("export a.deck -o a.msh");
    run("import a.msh -o c.mesh.txt --deck");
    run("export c.deck -o c.msh");
    EXPECT_EQ(testing::slurp(folder / "a.msh"), testing::slurp(folder / "c.msh"));
    run("export a.deck -o a.wkt");
    run("import a.wkt -o d.mesh.txt --material 1 --deck");
    run("export d.deck -o d.wkt");
    EXPECT_EQ(testing::slurp(folder / "a.wkt"), testing::slurp(folder / "d.wkt"));
    run("export a.deck -o a.txt");
    run("import a.txt -o e.mesh.txt --deck");
    run("export e.deck -o e.msh");
    EXPECT_EQ(testing::slurp(folder / "a.msh"), testing::slurp(folder / "e.msh"));
  }
}

}  // namespace
}  // namespace blocks::exchange
