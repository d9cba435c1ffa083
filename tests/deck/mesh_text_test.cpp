// The text form of READ9, and files that are no mesh.

#include "deck/mesh_samples.hpp"

namespace blocks::deck::testing {
namespace {

using ::testing::HasSubstr;

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

// The text form has free fields as a deck. It may have pentagons, which other mesh
// forms cannot.
TEST(MeshText, ReadsFreeFieldsAndEitherSense) {
  const MeshFile mesh =
      read("! x\r\nblocks\r\n5 3\r\n0,0\r\n+1.D0 ,0 $ c\r\n\r\n2,1\n1,2\n0 1E0");
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].outline, (Polygon{{0, 0}, {0, 1}, {1, 2}, {2, 1}, {1, 0}}));
  EXPECT_EQ(mesh.blocks[0].material, 3);
}

TEST(MeshErrors, NameAFileThatIsMissingOrAFolder) {
  try {
    read_mesh("/no/such/mesh.msh");
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(), "/no/such/mesh.msh: cannot open the mesh file: No such "
                               "file or directory");
  }
  EXPECT_THROW(read_mesh(std::filesystem::temp_directory_path().string()), MeshError);
}

TEST(MeshErrors, SayWhyAFileIsNoMesh) {
  EXPECT_EQ(refusal(""), ": the mesh file is empty");
  EXPECT_EQ(refusal(" \n\n"), ": the mesh file is empty");
  EXPECT_THAT(refusal("CREATE, 4\n"), HasSubstr(":1: not a mesh that READ9 knows"));
  EXPECT_THAT(refusal("\x89HDF\r\n\x1a\n"), HasSubstr("Exodus II?"));
  EXPECT_THAT(refusal(std::string("CDF\1\0\0\0\0", 8)), HasSubstr("netCDF"));
}

TEST(MeshErrors, TextFilesHaveLineAndReason) {
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

}  // namespace
}  // namespace blocks::deck::testing
