// GENESIS files and region records for READ9.
#include <limits>

#include "deck/mesh_samples.hpp"

namespace blocks::deck::testing {
namespace {

using ::testing::EndsWith;
using ::testing::Eq;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(MeshGenesis, ReadsEveryWordSizeAndByteOrder) {
  for (const bool big : {false, true})
    for (const std::size_t integers : {4u, 8u})
      for (const std::size_t reals : {4u, 8u}) {
        const MeshFile mesh = read(genesis(big, integers, reals).bytes);
        EXPECT_EQ(mesh.form, MeshForm::genesis);
        EXPECT_EQ(mesh.found, std::string("GENESIS, version word 1, ") +
                                  (big ? "big" : "little") + "-endian, " +
                                  std::to_string(integers) + "-byte integers, " +
                                  std::to_string(reals) +
                                  "-byte reals, 2 element blocks: 1 quadrilateral, "
                                  "1 triangle");
        ASSERT_EQ(mesh.blocks.size(), 2u);
        EXPECT_EQ(mesh.blocks[0].outline, (Polygon{{0, 0}, {0, 2}, {2, 2}, {2, 0}}));
        EXPECT_EQ(mesh.blocks[0].material, 5);
        EXPECT_EQ(mesh.blocks[1].outline, (Polygon{{2, 0}, {2, 2}, {4, 0.5}}));
        EXPECT_EQ(mesh.blocks[1].material, 2);
      }
}

// Older files have no version word, the tenth word of the sizes.
TEST(MeshGenesis, ReadsFilesWithoutVersionWord) {
  for (const std::size_t integers : {4u, 8u}) {
    const MeshFile mesh = read(genesis(true, integers, 4, false).bytes);
    EXPECT_THAT(mesh.found, StartsWith("GENESIS, no version word, big-endian, "));
    EXPECT_EQ(mesh.blocks.size(), 2u);
  }
}

TEST(MeshRegions, ReadsSharedNodesInEveryWordSizeAndByteOrder) {
  for (const bool big : {false, true})
    for (const std::size_t integers : {4u, 8u})
      for (const std::size_t reals : {4u, 8u}) {
        const MeshFile mesh = read(regions(big, integers, reals).bytes);
        EXPECT_EQ(mesh.form, MeshForm::regions);
        EXPECT_THAT(mesh.found,
                    EndsWith("3 regions: 2 quadrilaterals (1 bar skipped)"));
        ASSERT_EQ(mesh.blocks.size(), 2u);
        EXPECT_EQ(mesh.blocks[0].outline, square_clockwise);
        EXPECT_EQ(mesh.blocks[0].material, 3);
        EXPECT_EQ(mesh.blocks[1].outline, right_clockwise);
        EXPECT_EQ(mesh.blocks[1].material, 4);
      }
}

TEST(MeshErrors, GenesisFilesHaveRecordAndReason) {
  const FortranFile file = genesis();
  // NUMNP is at byte 92, after the title and three markers. NDIM, NUMEL, ... follow.
  const auto with = [&](std::size_t at, long value) {
    std::string bytes = file.bytes;
    return refusal(bytes.replace(
        at, 4, FortranFile::number(static_cast<std::uint64_t>(value), 4, false)));
  };
  EXPECT_THAT(with(92, 2147483647), HasSubstr(": record 3: coordinates: "));
  EXPECT_THAT(with(92, -1), HasSubstr(": record 2: no mesh: NUMNP -1"));
  EXPECT_THAT(with(96, 3), HasSubstr(": record 2: NDIM is 3"));
  EXPECT_THAT(with(100, 3), HasSubstr(": record 4: element map: 3 numbers expected"));
  EXPECT_THAT(with(104, 1), HasSubstr("NUMEL is 2, the element blocks have 1"));
  EXPECT_THAT(with(108, 1), Eq("read without complaint"));  // The file has sets.
  EXPECT_THAT(with(84, 81), HasSubstr(": record 1: opening marker 80 and closing"));

  const std::size_t connectivity = file.bytes.find(FortranFile::number(32, 4, false));
  EXPECT_THAT(with(connectivity + 4, 99),
              HasSubstr(": record 6: element 1 refers to node 99"));
  EXPECT_THAT(with(connectivity - 20, 0), HasSubstr("material 0 is not positive"));
  EXPECT_THAT(with(connectivity - 12, 5), HasSubstr("5 nodes per element"));
  EXPECT_THAT(with(connectivity - 12, 9), HasSubstr("9 numbers expected"));
}

TEST(MeshErrors, RegionsHaveRecordAndReason) {
  const FortranFile file = regions();
  const auto with = [&](std::size_t at, long value) {
    std::string bytes = file.bytes;
    return refusal(bytes.replace(
        at, 4, FortranFile::number(static_cast<std::uint64_t>(value), 4, false)));
  };
  EXPECT_THAT(with(4, 1000000), HasSubstr("region 3: 1000000 elements expected"));
  EXPECT_THAT(with(8, 1000000), HasSubstr("region 3: 1000000 nodes expected"));
  EXPECT_THAT(with(8, -4), HasSubstr(": record 1: region 3: -4 is not a valid count"));
}

TEST(MeshErrors, CoordinatesMustBeFinite) {
  FortranFile infinite{};
  infinite.integers({1, 3, 0, 0, 1, 0, 1}).end();
  const double inf = std::numeric_limits<double>::infinity();
  for (const long id : {1, 2, 3})
    infinite.integers({id}).reals({0, inf});
  infinite.end().integers({1, 2, 3, 0}).end();
  EXPECT_THAT(refusal(infinite.bytes), HasSubstr(": record 2: node 1 has a coordinate "
                                                 "that is not finite"));
}

}  // namespace
}  // namespace blocks::deck::testing
