// READ9's four mesh forms (docs/mesh-formats.md): what comes out of good files, and
// that bad ones are refused with the place and the reason. Binary files are written
// here byte by byte.
#include "deck/mesh_readers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using blocks::deck::MeshError;
using blocks::deck::MeshFile;
using blocks::deck::MeshForm;
using blocks::deck::read_mesh;
using blocks::geometry::Polygon;
using blocks::geometry::Vec2;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const std::string samples = BLOCKS_SOURCE_DIR "/tests/data/mesh/";

/// A file that goes away at the end of the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() /
              ("blocks_mesh_" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

MeshFile read(const std::string& bytes) {
  const TemporaryFile file(bytes);
  return read_mesh(file.path());
}

/// The message without the file's name: ":3: ...", ": record 2: ..." or ": ...".
std::string refusal(const std::string& bytes) {
  const TemporaryFile file(bytes);
  try {
    read_mesh(file.path());
  } catch (const MeshError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file.path())) << message;
    return message.substr(file.path().size());
  }
  return "read without complaint";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// Records between 4-byte markers, as a Fortran program writes them.
struct FortranFile {
  bool big_endian = false;
  std::size_t integer_width = 4, real_width = 8;
  std::string bytes, record;

  static std::string number(std::uint64_t value, std::size_t width, bool big) {
    std::string text;
    for (std::size_t i = 0; i < width; ++i)
      text += static_cast<char>(value >> 8 * (big ? width - 1 - i : i));
    return text;
  }
  FortranFile& integers(std::initializer_list<long> values) {
    for (const long value : values)
      record += number(static_cast<std::uint64_t>(value), integer_width, big_endian);
    return *this;
  }
  FortranFile& reals(std::initializer_list<double> values) {
    for (const double value : values)
      record += real_width == 4
                    ? number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4,
                             big_endian)
                    : number(std::bit_cast<std::uint64_t>(value), 8, big_endian);
    return *this;
  }
  FortranFile& text(std::string value, std::size_t length) {
    value.resize(length, ' ');
    record += value;
    return *this;
  }
  FortranFile& end() {
    const std::string marker = number(record.size(), 4, big_endian);
    bytes += marker + record + marker;
    record.clear();
    return *this;
  }
};

// Square and triangle: block 5 has a quadrilateral of 8 nodes written anticlockwise,
// block 2 a triangle as a quadrilateral with a repeated node.
FortranFile genesis(bool big = false, std::size_t integers = 4, std::size_t reals = 8,
                    bool version = true) {
  FortranFile file{big, integers, reals, "", ""};
  file.text("A SQUARE AND A TRIANGLE", 80).end();
  file.integers({9, 2, 2, 2, 0, 0, 0, 0, 0});
  if (version)
    file.integers({1});
  file.end();
  file.reals({0, 2, 2, 0, 1, 2, 1, 0, 4}).reals({0, 0, 2, 2, 0, 1, 2, 1, 0.5}).end();
  file.integers({1, 2}).end();
  file.integers({5, 1, 8, 0}).end();
  file.integers({1, 2, 3, 4, 5, 6, 7, 8}).end().reals({0}).end();
  file.integers({2, 1, 4, 1}).end();
  file.integers({2, 9, 3, 3}).end().reals({1}).end();
  for (int set = 0; set < 13; ++set)
    file.integers({0}).end();
  return file;
}

// Two regions that share two nodes, which the second does not repeat; a region of bars
// between them; boundary lists.
FortranFile regions(bool big = false, std::size_t integers = 4, std::size_t reals = 8) {
  FortranFile file{big, integers, reals, "", ""};
  file.integers({1, 4, 2, 3, 3, 0, 1}).end();
  const double x[] = {0, 1, 1, 0}, y[] = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i)
    file.integers({101 + i}).reals({x[i], y[i]});
  file.end().integers({101, 102, 103, 104}).end();
  file.integers({101, 102}).end().integers({1, 1, 101}).end();
  file.integers({1, 0, 0, 0, 9, 1, 1}).end().integers({101, 102, 0, 0}).end();
  file.integers({1, 2, 0, 0, 4, 0, 1}).end();
  file.integers({105}).reals({2, 0}).integers({106}).reals({2, 1}).end();
  return file.integers({102, 105, 106, 103}).end();
}

const Polygon square_clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
const Polygon right_clockwise{{1, 0}, {1, 1}, {2, 1}, {2, 0}};

TEST(MeshText, ReadsOutlinesAsWritten) {
  const MeshFile mesh = read_mesh(samples + "two_quads.txt");
  EXPECT_EQ(mesh.form, MeshForm::text);
  EXPECT_EQ(mesh.found, "text form, 2 blocks");
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(mesh.blocks[0].outline, square_clockwise);
  EXPECT_EQ(mesh.blocks[1].outline, right_clockwise);
  EXPECT_EQ(mesh.blocks[0].material, 1);
  EXPECT_EQ(mesh.blocks[1].material, 2);
  EXPECT_EQ(mesh.blocks[1].line, 8);
}

// The same liberties as in a deck, rule 15; a pentagon, which no mesh form has.
TEST(MeshText, TakesFreeFieldAndEitherTurn) {
  const MeshFile mesh =
      read("! x\r\nblocks\r\n5 3\r\n0,0\r\n+1.D0 ,0 $ c\r\n\r\n2,1\n1,2\n0 1E0");
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].outline, (Polygon{{0, 0}, {0, 1}, {1, 2}, {2, 1}, {1, 0}}));
  EXPECT_EQ(mesh.blocks[0].material, 3);
}

TEST(MeshGmsh, ReadsBothVersionsAlike) {
  for (const std::string version : {"2.2", "4.1"}) {
    const MeshFile mesh = read_mesh(samples + "two_quads_" + version + ".msh");
    EXPECT_EQ(mesh.form, MeshForm::gmsh);
    EXPECT_EQ(mesh.found, "Gmsh " + version +
                              " ASCII, 2 quadrilaterals (points and lines passed "
                              "over: 2)");
    ASSERT_EQ(mesh.blocks.size(), 2u);
    EXPECT_EQ(mesh.blocks[0].outline, square_clockwise);  // written anticlockwise
    EXPECT_EQ(mesh.blocks[1].outline, right_clockwise);
    EXPECT_EQ(mesh.blocks[0].material, 1);
    EXPECT_EQ(mesh.blocks[1].material, 2);  // the group; the surface is 12 in 4.1
  }
}

// Node 7 lies on a side of the triangle of 6 nodes and must not become a corner.
TEST(MeshGmsh, TakesCornersOfHigherOrderAndMaterialOneWithoutTags) {
  const std::string nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n$Nodes\n"
                            "$EndComments\n$Nodes\n6\n1 0 0 5\n2 2 0 5\n3 0 2 5\n"
                            "7 1 0 5\n8 1 1 5\n9 0 1 5\n$EndNodes\n$Elements\n1\n";
  const MeshFile mesh = read(nodes + "4 9 0 1 2 3 7 8 9\n$EndElements\n");
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].outline, (Polygon{{0, 0}, {0, 2}, {2, 0}}));
  EXPECT_EQ(mesh.blocks[0].material, 1);
  EXPECT_EQ(read(nodes + "4 9 2 0 8 1 2 3 7 8 9\n$EndElements\n").blocks[0].material,
            8);  // no group: the surface's tag
}

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

// The tenth word of the sizes came late; files without it are as good, and told apart.
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
        EXPECT_THAT(mesh.found, EndsWith("3 regions: 2 quadrilaterals (1 bar passed "
                                         "over)"));
        ASSERT_EQ(mesh.blocks.size(), 2u);
        EXPECT_EQ(mesh.blocks[0].outline, square_clockwise);
        EXPECT_EQ(mesh.blocks[0].material, 3);
        EXPECT_EQ(mesh.blocks[1].outline, right_clockwise);
        EXPECT_EQ(mesh.blocks[1].material, 4);
      }
}

TEST(MeshErrors, NameTheFileThatIsMissingEmptyOrAFolder) {
  try {
    read_mesh("/no/such/mesh.msh");
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(), "/no/such/mesh.msh: cannot open the mesh file: No such "
                               "file or directory");
  }
  EXPECT_THROW(read_mesh(std::filesystem::temp_directory_path().string()), MeshError);
  EXPECT_EQ(refusal(""), ": the mesh file is empty");
  EXPECT_EQ(refusal(" \n\n"), ": the mesh file is empty");
  EXPECT_THAT(refusal("CREATE, 4\n"), HasSubstr(":1: not a mesh that READ9 knows"));
  EXPECT_THAT(refusal("\x89HDF\r\n\x1a\n"), HasSubstr("Exodus II?"));
  EXPECT_THAT(refusal(std::string("CDF\1\0\0\0\0", 8)), HasSubstr("netCDF"));
}

TEST(MeshErrors, TextSaysLineAndReason) {
  const std::string good = "BLOCKS 1\n3 1\n0 0\n1 1\n1 0\n";
  EXPECT_EQ(read(good).blocks.size(), 1u);
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal(replaced(good, from, to));
  };
  EXPECT_EQ(with("1 1\n", "1\n"),
            ":4: block 1: corner 2 of 3: expected 2 coordinates, found 1");
  EXPECT_EQ(with("1 1\n", "1 l\n"),
            ":4: block 1: corner 2 of 3: y should be a number, found 'l'");
  EXPECT_EQ(with("1 1\n", "1,,1\n"), ":4: a value is missing before the comma");
  EXPECT_THAT(with("1 1\n", "1 nan\n"), HasSubstr(":4: "));
  EXPECT_THAT(with("1 1\n", "1 1e999\n"), HasSubstr("outside the range"));
  EXPECT_EQ(with("3 1", "2 1"), ":2: block 1 needs at least 3 corners");
  EXPECT_EQ(with("3 1", "3 0"), ":2: block 1: material 0 is not positive");
  EXPECT_THAT(with("3 1", "4000000000 1"), HasSubstr(":2: block 1: number of corners "
                                                     "4000000000 cannot be right"));
  EXPECT_EQ(with("3 1", "4 1"),
            ":5: the file ends where block 1: corner 4 of 4 should be");
  EXPECT_EQ(with("BLOCKS 1", "BLOCKS 2"), ":5: BLOCKS announces 2, the file has 1");
  EXPECT_EQ(refusal("BLOCKS\n"), ":1: no blocks after BLOCKS");
}

TEST(MeshErrors, GmshSaysLineAndReason) {
  std::ifstream in(samples + "two_quads_2.2.msh", std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  EXPECT_EQ(read(good).blocks.size(), 2u);
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal(replaced(good, from, to));
  };
  EXPECT_THAT(with("2.2 0 8", "2.2 1 8"), HasSubstr(":2: a binary Gmsh file"));
  EXPECT_THAT(with("2.2 0 8", "4 0 8"), HasSubstr(":2: Gmsh version '4' is not read"));
  EXPECT_THAT(with("2 1 0 0", "2 1e999 0 0"), HasSubstr(":12: x '1e999' is outside"));
  EXPECT_THAT(with("2 1 0 0", "1 1 0 0"), HasSubstr(":12: node 1 is given twice"));
  EXPECT_THAT(with("3 3 2 1 1 1 2 5 6", "3 3 2 1 1 1 2 5 7"),
              HasSubstr(":22: element 3 refers to node 7, which is not there"));
  EXPECT_THAT(with("3 3 2 1 1 1 2 5 6", "3 3 2 1 1 1 2 5"),
              HasSubstr(":22: element 3: expected 4 nodes, found 3"));
  EXPECT_THAT(with("3 3 2 1 1 1 2 5 6", "3 3 2 1 1 1 2 1 2"),
              HasSubstr(":22: element 3 repeats a node: 1, 2, 1, 2"));
  EXPECT_THAT(with("3 3 2 1 1 1 2 5 6", "3 2 2 1 1 1 2 3"),
              HasSubstr(":22: element 3 has no area"));
  EXPECT_THAT(with("3 3 2 1 1 1 2 5 6", "3 4 2 1 1 1 2 5 6"),
              HasSubstr(":22: Gmsh element type 4 is not read; READ9"));
  // An element in two groups is written twice in version 2: two blocks in one place.
  EXPECT_THAT(with("4 3 2 2 2 2 3 4 5", "4 3 2 2 1 2 5 6 1"),
              HasSubstr(":23: element 4 has the nodes of an earlier element"));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n600000000000"), HasSubstr(":10: number of"));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n7"), HasSubstr(":17: "));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n5"), HasSubstr(":16: expected $EndNodes"));

  std::ifstream in_4(samples + "two_quads_4.1.msh", std::ios::binary);
  const std::string good_4((std::istreambuf_iterator<char>(in_4)), {});
  EXPECT_EQ(read(replaced(good_4, "2 1 0 1 2 0", "2 1 0 0 0")).blocks[1].material,
            12);  // no group: the surface's tag
  EXPECT_THAT(refusal(replaced(good_4, "1 1 0 1 1 1 1 \n", "1 1 0 2 1 2 0 \n")),
              HasSubstr(":13: surface 11 is in 2 physical groups"));
  EXPECT_THAT(refusal(replaced(good_4, "3 6 1 6", "3 7 1 6")),
              HasSubstr("$Nodes announces 7, its blocks have 6"));
}

TEST(MeshErrors, BinaryFormsSayRecordAndReason) {
  FortranFile file = genesis();
  // Marker, title, marker; marker, NUMNP at byte 92, NDIM, NUMEL, ...
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
  EXPECT_THAT(with(108, 1), testing::Eq("read without complaint"));  // sets are there
  EXPECT_THAT(with(84, 81), HasSubstr(": record 1: opening marker 80 and closing"));

  const std::size_t connectivity = file.bytes.find(FortranFile::number(32, 4, false));
  EXPECT_THAT(with(connectivity + 4, 99),
              HasSubstr(": record 6: element 1 refers to node 99"));
  EXPECT_THAT(with(connectivity - 20, 0), HasSubstr("material 0 is not positive"));
  EXPECT_THAT(with(connectivity - 12, 5), HasSubstr("5 nodes per element"));
  EXPECT_THAT(with(connectivity - 12, 9), HasSubstr("9 numbers expected"));

  file = regions();
  EXPECT_THAT(with(4, 1000000), HasSubstr("region 3: 1000000 elements expected"));
  EXPECT_THAT(with(8, 1000000), HasSubstr("region 3: 1000000 nodes expected"));
  EXPECT_THAT(with(8, -4), HasSubstr(": record 1: region 3: -4 is no count"));

  FortranFile infinite{};
  infinite.integers({1, 3, 0, 0, 1, 0, 1}).end();
  const double inf = std::numeric_limits<double>::infinity();
  for (const long id : {1, 2, 3})
    infinite.integers({id}).reals({0, inf});
  infinite.end().integers({1, 2, 3, 0}).end();
  EXPECT_THAT(refusal(infinite.bytes), HasSubstr(": record 2: node 1 has a coordinate "
                                                 "that is not finite"));
}

// Whatever is done to a file, it is read or refused with its name and a reason: no
// crash, no wild allocation, and nothing but finite outlines comes out.
TEST(MeshErrors, SurviveMutation) {
  const auto sample = [](const std::string& name) {
    std::ifstream in(samples + name, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {});
  };
  const std::vector<std::string> seeds{
      sample("two_quads.txt"),     sample("two_quads_2.2.msh"),
      sample("two_quads_4.1.msh"), genesis().bytes,
      genesis(true, 8, 4).bytes,   regions().bytes,
      regions(true, 8, 4).bytes};
  // Bytes that hurt: signs, huge counts, marks of other lengths, not-a-number.
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
      case 0:  // a bit, often in a binary number
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
      const MeshFile mesh = blocks::deck::parse_mesh("mutant", bytes);
      ++read;
      for (const auto& block : mesh.blocks) {
        EXPECT_GE(block.outline.size(), 3u);
        for (const Vec2& corner : block.outline)
          EXPECT_TRUE(corner.allFinite());
      }
    } catch (const MeshError& error) {
      ++refused;
      EXPECT_THAT(error.what(), StartsWith("mutant:"));
    }
  }
  // Both happen, so that the mutants are neither all harmless nor all hopeless.
  EXPECT_GT(read, 1000u);
  EXPECT_GT(refused, 10000u);
}

// A mesh drawn in another plane must not be flattened in silence.
TEST(MeshErrors, GmshElementsLieInOnePlane) {
  const std::string mesh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 5\n2 2 0 5\n3 0 2 5\n"
      "$EndNodes\n$Elements\n1\n4 2 0 1 2 3\n$EndElements\n";
  EXPECT_EQ(read(mesh).blocks.size(), 1u);
  EXPECT_THAT(
      refusal(replaced(mesh, "3 0 2 5", "3 0 2 6")),
      HasSubstr(":12: element 4 leaves the plane of the mesh: node 3 has z = 6, "
                "others 5"));
}

// Only whole region files of fewer regions, and a GENESIS file without the records of
// its empty sets, are meshes in themselves; any other cut must be noticed.
TEST(MeshErrors, NoticeTruncationAtEveryByte) {
  std::ifstream in(samples + "two_quads_4.1.msh", std::ios::binary);
  const std::string gmsh((std::istreambuf_iterator<char>(in)), {});
  for (std::size_t n = 0; n + 1 < gmsh.size(); ++n)
    EXPECT_NE(refusal(gmsh.substr(0, n)), "read without complaint") << n;
  std::size_t accepted = 0;
  const std::string tape = genesis(true).bytes;
  for (std::size_t n = 0; n < tape.size(); ++n)
    if (refusal(tape.substr(0, n)) == "read without complaint")
      ++accepted;
  EXPECT_EQ(accepted, 13u);
  accepted = 0;
  const std::string scratch = regions().bytes;
  for (std::size_t n = 0; n < scratch.size(); ++n)
    if (refusal(scratch.substr(0, n)) == "read without complaint")
      ++accepted;
  EXPECT_EQ(accepted, 2u);
}

}  // namespace
