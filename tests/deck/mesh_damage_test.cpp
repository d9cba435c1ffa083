// Damaged mesh files are read, or refused with a name and a reason.
#include <filesystem>
#include <random>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "deck/mesh_samples.hpp"

namespace blocks::deck::testing {
namespace {

using ::testing::StartsWith;

// Meshes that are read have finite outlines only.
TEST(MeshErrors, MutantsAreReadOrRefused) {
  const std::vector<std::string> seeds{
      sample("two_quads.txt"),     sample("two_quads_2.2.msh"),
      sample("joints.txt"),        sample("joints.msh"),
      sample("two_quads_4.1.msh"), genesis().bytes,
      genesis(true, 8, 4).bytes,   regions().bytes,
      regions(true, 8, 4).bytes};
  // These are signs, huge counts, record markers of other lengths and NaNs.
  const std::vector<std::string> splices{"-",
                                         "999999999999",
                                         "9",
                                         "nan",
                                         "1e999",
                                         "$",
                                         "\n",
                                         ",",
                                         {"\0\0\0\0", 4},
                                         "\xff\xff\xff\xff",
                                         "\x7f\xf8",
                                         {"\0\0\0\x50", 4}};
  std::mt19937 random(27);
  const auto below = [&](std::size_t n) { return random() % n; };
  std::size_t read = 0, refused = 0;
  for (int mutant = 0; mutant < 20000; ++mutant) {
    std::string bytes = seeds[below(seeds.size())];
    for (std::size_t change = 0; change <= below(3); ++change) {
      const std::size_t at = below(bytes.size() + 1);
      switch (below(4)) {
      case 0:  // This changes one bit.
        if (at < bytes.size())
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes.resize(std::max<std::size_t>(at, 1));
        break;
      case 2: {
        const std::string& splice = splices[below(splices.size())];
        bytes.replace(at, below(2) * splice.size(), splice);
        break;
      }
      default:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
      }
    }
    try {
      const MeshFile mesh = parse_mesh("mutant", bytes);
      ++read;
      for (const auto& block : mesh.blocks) {
        EXPECT_GE(block.outline.size(), 3u);
        for (const Vec2& corner : block.outline)
          EXPECT_TRUE(corner.allFinite());
        if (!block.joints.empty()) {
          EXPECT_EQ(block.joints.size(), block.outline.size());
        }
      }
    } catch (const MeshError& error) {
      ++refused;
      EXPECT_THAT(error.what(), StartsWith("mutant:"));
    }
  }
  // The mutants must reach both outcomes.
  EXPECT_GT(read, 1000u);
  EXPECT_GT(refused, 10000u);
}

// Opening a pipe without a writer would wait for ever.
TEST(MeshErrors, PipesAndDevicesAreRefused) {
  const auto pipe = std::filesystem::temp_directory_path() /
                    ("blocks_mesh_pipe_" + std::to_string(::getpid()));
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe.string(), std::string("/dev/zero")})
    try {
      read_mesh(path);
      ADD_FAILURE() << path << " is read";
    } catch (const MeshError& error) {
      EXPECT_EQ(error.what(),
                path + ": cannot read the mesh file: it is a device or a pipe");
    }
  std::filesystem::remove(pipe);
}

TEST(MeshErrors, GmshFilesAreRefusedIfTruncatedAnywhere) {
  const std::string gmsh = sample("two_quads_4.1.msh");
  for (std::size_t n = 0; n + 1 < gmsh.size(); ++n)
    EXPECT_NE(refusal(gmsh.substr(0, n)), "read without complaint") << n;
}

// A file without the records of its empty sets is a mesh.
TEST(MeshErrors, GenesisFilesAreRefusedIfTruncatedWithinTheMesh) {
  std::size_t accepted = 0;
  const std::string tape = genesis(true).bytes;
  for (std::size_t n = 0; n < tape.size(); ++n)
    if (refusal(tape.substr(0, n)) == "read without complaint")
      ++accepted;
  EXPECT_EQ(accepted, 13u);
}

// A file with fewer regions is a mesh.
TEST(MeshErrors, RegionsAreRefusedIfTruncatedWithinARegion) {
  std::size_t accepted = 0;
  const std::string scratch = regions().bytes;
  for (std::size_t n = 0; n < scratch.size(); ++n)
    if (refusal(scratch.substr(0, n)) == "read without complaint")
      ++accepted;
  EXPECT_EQ(accepted, 2u);
}

}  // namespace
}  // namespace blocks::deck::testing
