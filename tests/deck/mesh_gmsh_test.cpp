// Gmsh files for READ9, versions 2.2 and 4.1.

#include "deck/mesh_samples.hpp"

namespace blocks::deck::testing {
namespace {

using ::testing::HasSubstr;

TEST(MeshGmsh, ReadsBothVersionsAlike) {
  for (const std::string version : {"2.2", "4.1"}) {
    const MeshFile mesh = read_mesh(samples + "two_quads_" + version + ".msh");
    EXPECT_EQ(mesh.form, MeshForm::gmsh);
    EXPECT_EQ(mesh.found, "Gmsh " + version +
                              " ASCII, 2 quadrilaterals (points and lines skipped: 2)");
    ASSERT_EQ(mesh.blocks.size(), 2u);
    EXPECT_EQ(mesh.blocks[0].outline,
              square_clockwise);  // The file has it anticlockwise.
    EXPECT_EQ(mesh.blocks[1].outline, right_clockwise);
    EXPECT_EQ(mesh.blocks[0].material, 1);
    EXPECT_EQ(mesh.blocks[1].material,
              2);  // This is the group. The surface is 12 in 4.1.
  }
}

/// The nodes of a triangle of 6 nodes. Nodes 7, 8 and 9 are on its sides.
const std::string nodes_of_a_triangle =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n$Nodes\n"
    "$EndComments\n$Nodes\n6\n1 0 0 5\n2 2 0 5\n3 0 2 5\n"
    "7 1 0 5\n8 1 1 5\n9 0 1 5\n$EndNodes\n$Elements\n1\n";

TEST(MeshGmsh, ReadsOnlyTheCornersOfHigherOrderElements) {
  const MeshFile mesh = read(nodes_of_a_triangle + "4 9 0 1 2 3 7 8 9\n$EndElements\n");
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].outline, (Polygon{{0, 0}, {0, 2}, {2, 0}}));
}

TEST(MeshGmsh, HasMaterialOneWithoutTags) {
  const MeshFile mesh = read(nodes_of_a_triangle + "4 9 0 1 2 3 7 8 9\n$EndElements\n");
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].material, 1);
}

TEST(MeshGmsh, HasTheTagOfItsSurfaceAsMaterialWithoutAGroup) {
  EXPECT_EQ(read(nodes_of_a_triangle + "4 9 2 0 8 1 2 3 7 8 9\n$EndElements\n")
                .blocks[0]
                .material,
            8);
  const std::string good_4 = sample("two_quads_4.1.msh");
  EXPECT_EQ(read(replaced(good_4, "2 1 0 1 2 0", "2 1 0 0 0")).blocks[1].material, 12);
}

// The elements are triangles of the first block. They are not read.
TEST(MeshGmsh, ReadsTheBlocksOfItsOwnSection) {
  const MeshFile mesh = read_mesh(samples + "joints.msh");
  EXPECT_EQ(mesh.found, "Gmsh 2.2 ASCII, 2 blocks of $Blocks");
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(mesh.blocks[0].outline,
            (Polygon{{0, 0}, {0, 1}, {0.5, 0.25}, {1, 1}, {1, 0}}));
  EXPECT_EQ(mesh.blocks[0].joints, (std::vector<int>{1, 2, 0, 3, 4}));
  EXPECT_TRUE(mesh.blocks[0].fixed);
  EXPECT_EQ(mesh.blocks[1].joints, (std::vector<int>{3, 0, 0}));
  EXPECT_EQ(mesh.blocks[1].material, 2);
  EXPECT_FALSE(mesh.blocks[1].fixed);
}

TEST(MeshErrors, GmshFilesOfVersion2HaveLineAndReason) {
  const std::string good = sample("two_quads_2.2.msh");
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
  // Version 2 repeats an element that is in two groups.
  EXPECT_THAT(with("4 3 2 2 2 2 3 4 5", "4 3 2 2 1 2 5 6 1"),
              HasSubstr(":23: element 4 has the nodes of an earlier element"));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n600000000000"), HasSubstr(":10: number of"));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n7"), HasSubstr(":17: "));
  EXPECT_THAT(with("$Nodes\n6", "$Nodes\n5"), HasSubstr(":16: expected $EndNodes"));
}

TEST(MeshErrors, GmshFilesOfVersion4HaveLineAndReason) {
  const std::string good_4 = sample("two_quads_4.1.msh");
  EXPECT_THAT(refusal(replaced(good_4, "1 1 0 1 1 1 1 \n", "1 1 0 2 1 2 0 \n")),
              HasSubstr(":13: surface 11 is in 2 physical groups"));
  EXPECT_THAT(refusal(replaced(good_4, "3 6 1 6", "3 7 1 6")),
              HasSubstr("$Nodes announces 7, its blocks have 6"));
}

TEST(MeshErrors, GmshElementsMustBeInOnePlane) {
  const std::string mesh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 5\n2 2 0 5\n3 0 2 5\n"
      "$EndNodes\n$Elements\n1\n4 2 0 1 2 3\n$EndElements\n";
  EXPECT_EQ(read(mesh).blocks.size(), 1u);
  EXPECT_THAT(
      refusal(replaced(mesh, "3 0 2 5", "3 0 2 6")),
      HasSubstr(":12: element 4 leaves the plane of the mesh: node 3 has z = 6, "
                "others 5"));
}

}  // namespace
}  // namespace blocks::deck::testing
