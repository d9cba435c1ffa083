// Joint ids in GeoJSON, WKT, Gmsh files and READ9's text form. Blocks that are written
// and read again have the same corners, order of corners and joint ids, bit by bit.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include "deck/mesh/mesh_readers.hpp"
#include "exchange/block_record.hpp"
#include "exchange/geojson_reader.hpp"
#include "exchange/mesh_writer.hpp"
#include "exchange/wkt_reader.hpp"
#include "geometry/polygon.hpp"
#include "geometry/triangles.hpp"
#include "tools/program.hpp"

namespace blocks::exchange {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::TemporaryFolder;

bool same_bits(const geometry::Polygon& a, const geometry::Polygon& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const geometry::Vec2& p, const geometry::Vec2& q) {
                      return bits(p.x()) == bits(q.x()) && bits(p.y()) == bits(q.y());
                    });
}

/// Returns star-shaped blocks, one in each cell of a row of squares. Most are not
/// convex. Some have 3 corners, some corners at the ends of an axis are -0.
std::vector<BlockRecord> random_stars(std::uint64_t seed, double scale, double offset,
                                      bool with_joints = true) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<BlockRecord> blocks;
  for (int cell = 0; cell < 8; ++cell) {
    BlockRecord block;
    block.number = cell + 1;
    block.material = 1 + static_cast<int>(random() % 3);
    block.fixed = random() % 3 == 0;
    const std::size_t n = 3 + random() % 9;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = -2 * std::numbers::pi *
                           (static_cast<double>(i) + 0.8 * part(random)) /
                           static_cast<double>(n);
      const double radius = 0.1 + 0.35 * part(random);
      block.outline.emplace_back(offset +
                                     scale * (cell + 0.5 + radius * std::cos(angle)),
                                 offset + scale * (0.5 + radius * std::sin(angle)));
      if (with_joints)
        block.joints.push_back(random() % 3 == 0 ? 0
                                                 : static_cast<int>(random() >> 33));
    }
    if (cell == 0 && offset == 0.0 && n > 3) {
      block.outline[0].y() = -0.0;
      block.outline[1].x() = std::copysign(5e-324, block.outline[1].x());
    }
    const geometry::OutlineCheck check = geometry::check_outline(block.outline);
    if (check.fault == geometry::OutlineFault::none && !check.anticlockwise)
      blocks.push_back(block);
  }
  return blocks;
}

std::vector<int> all_joints(const std::vector<int>& joints, std::size_t corners) {
  return joints.empty() ? std::vector<int>(corners, 0) : joints;
}

/// Requires that the mesh has the blocks. READ9 corrects the sense of blocks that are
/// so flat that doubles do not show it; so does this function.
void expect_blocks(deck::MeshFile mesh, const std::vector<BlockRecord>& blocks,
                   bool with_material, bool with_fixed) {
  ASSERT_EQ(mesh.blocks.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    deck::MeshBlock& read = mesh.blocks[b];
    std::vector<int> joints = all_joints(read.joints, read.outline.size());
    if (geometry::check_outline(read.outline).anticlockwise) {
      read.outline = geometry::reversed(read.outline);
      std::reverse(joints.begin(), joints.end());
    }
    EXPECT_TRUE(same_bits(read.outline, blocks[b].outline)) << b;
    EXPECT_EQ(joints, all_joints(blocks[b].joints, blocks[b].outline.size())) << b;
    if (with_material) {
      EXPECT_EQ(read.material, blocks[b].material) << b;
    }
    if (with_fixed) {
      EXPECT_EQ(read.fixed, blocks[b].fixed) << b;
    }
  }
}

/// Requires the same blocks after the steps of `blocks import`: outlines are made
/// clockwise and written in the text form.
void expect_back(OutlineFile file, const std::vector<BlockRecord>& blocks,
                 bool with_properties) {
  ASSERT_TRUE(file.messages.empty()) << file.messages[0].text;
  ASSERT_EQ(file.outlines.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Outline& outline = file.outlines[b];
    if (with_properties) {
      EXPECT_EQ(outline.material, blocks[b].material);
      EXPECT_EQ(outline.fixed, blocks[b].fixed);
    }
    reverse(outline);
    outline.material = blocks[b].material;
  }
  expect_blocks(deck::parse_mesh("mesh", write_mesh(file.outlines, "law")), blocks,
                true, false);
}

TEST(JointIds, AreReadBackWithTheBitsOfRandomBlocks) {
  std::size_t blocks_read = 0, concave = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const double scales[] = {1.0, 1e-3, 1e6, 1e-310};
    const double scale = scales[seed % 4];
    const double offset = seed % 5 == 0 ? 1e9 * std::max(scale, 1e-4) : 0.0;
    const auto blocks = random_stars(seed, scale, offset);
    if (blocks.empty())
      continue;
    blocks_read += blocks.size();
    for (const BlockRecord& block : blocks)
      concave += geometry::check_outline(block.outline).convex ? 0 : 1;
    expect_back(read_geojson(write_geojson(blocks)), blocks, true);
    expect_back(read_wkt(write_wkt(blocks)), blocks, false);
    expect_blocks(deck::parse_mesh("mesh", write_gmsh(blocks)), blocks, true, true);
    if (HasFailure())
      return;
  }
  EXPECT_GT(blocks_read, 2500u);
  EXPECT_GT(concave, 1500u);
}

/// The unit square with joints 1 to 4 on its left, upper, right and lower side.
std::vector<BlockRecord> square() {
  BlockRecord block;
  block.number = block.material = 1;
  block.outline = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  block.joints = {1, 2, 3, 4};
  return {block};
}

// Rings are anticlockwise: they begin with the lower side, which has id 4.
TEST(JointIds, BelongToTheSidesOfTheRingAsWritten) {
  EXPECT_EQ(write_wkt(square()), "POLYGON M ((0 0 4, 1 0 3, 1 1 2, 0 1 1, 0 0 4))\n");
  EXPECT_THAT(write_geojson(square()), HasSubstr("\"joints\": [4, 3, 2, 1]"));
  EXPECT_THAT(write_gmsh(square()),
              HasSubstr("$Blocks\n1\n1 0 4 1 1 4 2 3 3 2 4\n$EndBlocks\n$Elements\n5\n"
                        "1 1 2 1 1 1 4\n2 1 2 2 2 4 3\n3 1 2 3 3 3 2\n4 1 2 4 4 2 1\n"
                        "5 3 2 1 1 1 2 3 4\n$EndElements\n"));
}

TEST(JointIds, AreNotWrittenIfAllAreZero) {
  auto blocks = square();
  const auto all = [&] {
    return write_wkt(blocks) + write_geojson(blocks) + write_gmsh(blocks);
  };
  blocks[0].joints = {0, 0, 0, 0};
  const std::string zero = all();
  blocks[0].joints.clear();
  EXPECT_EQ(zero, all());
  EXPECT_EQ(zero.find("joints"), zero.npos);
  EXPECT_EQ(zero.find(" M "), zero.npos);
  EXPECT_EQ(zero.find("$Blocks"), zero.npos);
}

TEST(JointIds, FollowTheirSideIfATextFileIsAnticlockwise) {
  const auto mesh = deck::parse_mesh(
      "mesh", "BLOCKS\n4 1\n0 0 4\n1 0\n1 1 2\n0 1 1\n3 1\n0 0\n0 1\n1 0");
  EXPECT_THAT(mesh.blocks[0].joints, ElementsAre(1, 2, 0, 4));
  EXPECT_TRUE(mesh.blocks[1].joints.empty());
}

// Without the section $Blocks, as Gmsh saves the file, the elements are read.
TEST(JointIds, ElementsOfAGmshFileFillTheBlocks) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto blocks = random_stars(seed, 1.0, 0.0);
    std::string text = write_gmsh(blocks);
    const auto begin = text.find("$Blocks"), end = text.find("$Elements");
    text.erase(begin, end - begin);
    double area = 0, whole = 0;
    for (const deck::MeshBlock& element : deck::parse_mesh("mesh", text).blocks)
      area += geometry::section_properties(element.outline).area;
    for (const BlockRecord& block : blocks)
      whole += geometry::section_properties(block.outline).area;
    EXPECT_NEAR(area, whole, 1e-12 * whole) << seed;
  }
}

// Straight corners, as at T-junctions, are corners of triangles with an area.
TEST(JointIds, TrianglesUseStraightCorners) {
  const geometry::Polygon outline = {{0, 0}, {0, 1}, {0, 3}, {1, 3},
                                     {1, 2}, {3, 2}, {3, 0}, {1, 0}};
  double area = 0;
  std::vector<int> used(outline.size(), 0);
  for (const auto& triangle : geometry::triangles(outline)) {
    geometry::Polygon corners;
    for (const int c : triangle) {
      corners.push_back(outline[static_cast<std::size_t>(c)]);
      used[static_cast<std::size_t>(c)] = 1;
    }
    EXPECT_GT(geometry::section_properties(corners).area, 0.0);
    area += geometry::section_properties(corners).area;
  }
  EXPECT_EQ(area, 7.0);
  EXPECT_EQ(used, std::vector<int>(outline.size(), 1));
  EXPECT_TRUE(geometry::triangles({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).empty());
}

constexpr const char* deck_of_stars =
    "START, 10, 12\nSTARS\nXLIMITS, {0}, {1}\nYLIMITS, {0}, {1}\nBOXES, 10, 10, 0.001\n"
    "FRACTION, 0.02\nMATERIAL, 1, 1.E9, 4.E8, 2000\nMATERIAL, 2, 1.E9, 4.E8, 2500\n"
    "MATERIAL, 3, 1.E9, 4.E8, 2500\nRIGID\nEND\nREAD9, '{2}'\nSTOP\n";

// Each format is exported, imported and exported again, and read by READ9 directly
// where it is a mesh. All exports have the same bytes.
TEST(JointIds, GiveTheSameFilesAgain) {
  for (const double offset : {0.0, 1e9}) {
    const TemporaryFolder folder;
    const auto blocks = random_stars(7, 1.0, offset);
    const auto deck = [&](const std::string& mesh) {
      return fmt::format(deck_of_stars, offset - 5, offset + 15, mesh);
    };
    const auto run = [&](const std::string& arguments) {
      const Outcome outcome = testing::blocks(arguments, folder.path());
      EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
      return outcome.out;
    };
    const auto expect_equal = [&](const std::string& a, const std::string& b) {
      EXPECT_EQ(testing::slurp(folder / a), testing::slurp(folder / b))
          << a << " " << b;
      EXPECT_GT(testing::slurp(folder / a).size(), 500u);
    };
    folder.write("a.msh", write_gmsh(blocks));
    folder.write("a.deck", deck("a.msh"));
    EXPECT_THAT(run("export a.deck -o b.msh"), ::testing::Not(HasSubstr("leaves out")));
    expect_equal("a.msh", "b.msh");
    run("export a.deck -o a.geojson");
    EXPECT_THAT(testing::slurp(folder / "a.geojson"), HasSubstr("\"fixed\": true"));
    run("import a.geojson -o b.mesh.txt --deck");
    run("export b.deck -o b.geojson");
    expect_equal("a.geojson", "b.geojson");
    run("import a.msh -o c.mesh.txt --deck");
    run("export c.deck -o c.geojson");
    expect_equal("a.geojson", "c.geojson");
    run("export a.deck -o a.txt");
    folder.write("d.deck", deck("a.txt"));
    run("export a.deck -o a.wkt");
    run("export d.deck -o d.wkt");
    expect_equal("a.wkt", "d.wkt");
    run("import a.wkt -o e.mesh.txt --material 1 --deck");
    run("export e.deck -o e.wkt");
    expect_equal("a.wkt", "e.wkt");
  }
}

// The error is at the card, with the line of the mesh and a hint.
TEST(JointIds, ThatAreMalformedAreAnErrorOfRead9) {
  const TemporaryFolder folder;
  folder.write("a.txt", "BLOCKS\n3 1\n0 0 1\n0 1 -1\n1 0 1\n");
  folder.write("a.deck", fmt::format(deck_of_stars, -5, 15, "a.txt"));
  const Outcome outcome = testing::blocks("check a.deck", folder.path());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              HasSubstr("a.deck:12:1: error: READ9: a.txt:4: block 1: corner 2 of 3: "
                        "joint id should be a whole number from 0 to 2147483647, found "
                        "'-1'"));
  EXPECT_THAT(outcome.err, HasSubstr("hint: a joint id names the joint of the side"));
}

}  // namespace
}  // namespace blocks::exchange
