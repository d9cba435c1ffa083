// A map in a drawing becomes a deck of certified blocks: `blocks import --map`, OUTLINE
// with a file, and the layer of TRACES.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exchange/dxf_text.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A square of 4 x 4 with a bed at y = 2 and two faults at x = 1 and x = 3.
std::string map_of_beds(int unit = 0) {
  return dxf_drawing(
      dxf_ring("boundary", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}) +
          dxf_line("beds", -1, 2, 5, 2) + dxf_line("7_faults", 1, -1, 1, 5) +
          dxf_line("7_faults", 3, 5, 3, -1) + dxf_line("grid", 0.5, 0, 0.5, 4),
      unit);
}

TEST(Map, BecomesADeckThatCutsCertifiedBlocks) {
  const TemporaryFolder folder;
  folder.write("map.dxf", map_of_beds());
  const Outcome import =
      blocks("import map.dxf --map --layer grid=skip", folder.path());
  ASSERT_EQ(import.code, 0) << import.err;
  EXPECT_EQ(import.out, "map.dxf: DXF, 5 polylines, 8 segments\n"
                        "layer boundary: the outline\n"
                        "layer beds: joint 1, 1 line\n"
                        "layer 7_faults: joint 7, 2 lines\n"
                        "layer grid: skipped\n"
                        "6 blocks, certified\n"
                        "written: map.deck\n");
  const std::string deck = slurp(folder / "map.deck");
  EXPECT_THAT(deck, HasSubstr("START, 6, 4\n"));
  EXPECT_THAT(deck, HasSubstr("OUTLINE, , 1, 'map.dxf', 'boundary'\n"
                              "TRACES, 'map.dxf', 1, , 'beds'\n"
                              "TRACES, 'map.dxf', 7, , '7_faults'\nCUT\n"));
  const Outcome check = blocks("check map.deck", folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_EQ(check.err, "");
  EXPECT_THAT(check.out, HasSubstr("6"));
  const Outcome exported = blocks("export map.deck -o b.geojson", folder.path());
  EXPECT_THAT(slurp(folder / "b.geojson"),
              AllOf(HasSubstr("7"), HasSubstr("\"joints\"")));
}

// The deck names the map from its own folder.
TEST(Map, IsNamedFromTheFolderOfTheDeck) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "maps");
  std::filesystem::create_directory(folder / "decks");
  folder.write("maps/m.dxf", map_of_beds());
  ASSERT_EQ(blocks("import maps/m.dxf --map -o decks/m.deck", folder.path()).code, 0);
  EXPECT_THAT(slurp(folder / "decks/m.deck"), HasSubstr("'../maps/m.dxf'"));
  EXPECT_EQ(blocks("check decks/m.deck", folder.path()).code, 0);
}

TEST(Map, TakesTheOutlineFromAnotherFileOrTheBoxOfTheTraces) {
  const TemporaryFolder folder;
  folder.write("t.csv", "x1,y1,x2,y2\n0,0,2,2\n0,2,2,0\n");
  folder.write("o.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))");
  const Outcome box = blocks("import t.csv --map", folder.path());
  EXPECT_EQ(box.code, 0) << box.err;
  EXPECT_THAT(box.out, AllOf(HasSubstr("the outline is the box around the traces"),
                             HasSubstr("4 blocks, certified")));
  const Outcome given =
      blocks("import t.csv --map --outline o.wkt -o g.deck", folder.path());
  EXPECT_EQ(given.code, 0) << given.err;
  EXPECT_THAT(given.out, HasSubstr("3 blocks, certified"));
  EXPECT_THAT(slurp(folder / "g.deck"), HasSubstr("OUTLINE, , 1, 'o.wkt'\n"));
}

TEST(Map, OfGeoJsonKeepsIdsAndTakesAClosedLineAsOutline) {
  const TemporaryFolder folder;
  const auto line = [](const std::string& properties, const std::string& points) {
    return "{\"type\": \"Feature\", \"properties\": {" + properties +
           "}, \"geometry\": {\"type\": \"LineString\", \"coordinates\": [" + points +
           "]}}";
  };
  const auto write = [&](const std::string& first, const std::string& second) {
    folder.write("m.geojson",
                 "{\"type\": \"FeatureCollection\", \"crs\": null, \"features\": [" +
                     line(R"("layer": "w")", "[0, 0], [8, 0], [8, 8], [0, 8], [0, 0]") +
                     ", " + line(first, "[-1, 3], [9, 3]") + ", " +
                     line(second, "[3, -1], [3, 9]") + "]}");
    return blocks("import m.geojson --map", folder.path());
  };
  const Outcome layers = write(R"("layer": "a")", R"("layer": 5)");
  EXPECT_EQ(layers.code, 0) << layers.err;
  EXPECT_THAT(layers.out, AllOf(HasSubstr("layer w: the outline\n"),
                                HasSubstr("layer 5: joint 5, 1 line\n"),
                                HasSubstr("4 blocks, certified")));
  EXPECT_EQ(blocks("check m.deck", folder.path()).code, 0);
  const Outcome some = write(R"("layer": "a")", "");
  EXPECT_EQ(some.code, 2);
  EXPECT_THAT(some.err, HasSubstr("1 line has no layer, and the others have one"));
  const Outcome ids =
      write(R"("layer": "a", "joint": 7)", R"("layer": "a", "joint": 9)");
  EXPECT_THAT(ids.out, HasSubstr("joint ids are those of the file"));
}

// Names with one kind of quotes, commas and $ are kept; a card cannot have both quotes.
TEST(Map, KeepsOddNamesOfLayers) {
  const TemporaryFolder folder;
  const std::string odd = dxf_ring("win", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}) +
                          dxf_line("a$b", -1, 1, 5, 1) + dxf_line("it's", -1, 2, 5, 2) +
                          dxf_line("x, \"y\"", -1, 3, 5, 3);
  folder.write("m.dxf", dxf_drawing(odd));
  ASSERT_EQ(blocks("import m.dxf --map", folder.path()).code, 0);
  const Outcome check = blocks("check m.deck", folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("4 blocks"));
  folder.write("m.dxf", dxf_drawing(odd + dxf_line("q\"u'o", -1, 3.5, 5, 3.5)));
  const Outcome refused = blocks("import m.dxf --map", folder.path());
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("cannot be named in a deck"));
}

// A bed that ends a centimetre before the boundary cuts after --snap only.
TEST(Map, ProposesAndTakesSnap) {
  const TemporaryFolder folder;
  folder.write("m.dxf", dxf_drawing(dxf_ring("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}) +
                                    dxf_line("beds", -1, 2, 3.99, 2)));
  const Outcome loose = blocks("import m.dxf --map", folder.path());
  EXPECT_EQ(loose.code, 0);
  EXPECT_THAT(loose.out, HasSubstr("1 block, certified"));
  EXPECT_THAT(loose.err, HasSubstr("snap"));
  const Outcome joined = blocks("import m.dxf --map --snap .02", folder.path());
  EXPECT_THAT(joined.out, HasSubstr("2 blocks, certified"));
  EXPECT_EQ(joined.err, "");
  EXPECT_THAT(slurp(folder / "m.deck"),
              HasSubstr("TRACES, 'm.dxf', 1, 0.02, 'beds'\n"));
}

TEST(Map, AsksWhichClosedLineIsTheOutline) {
  const TemporaryFolder folder;
  folder.write("m.dxf", dxf_drawing(dxf_ring("a", {{0, 0}, {4, 0}, {4, 4}}) +
                                    dxf_ring("tunnel", {{2, 1}, {3, 1}, {3, 2}}) +
                                    dxf_line("joints", 0, 1, 4, 1.5)));
  const Outcome import = blocks("import m.dxf --map", folder.path());
  EXPECT_EQ(import.code, 2);
  EXPECT_THAT(import.err, AllOf(HasSubstr("several closed lines may be the outline"),
                                HasSubstr("--layer NAME=outline"),
                                HasSubstr("tunnel (1 line, 1 closed)")));
  const Outcome named = blocks("import m.dxf --map --layer a=outline", folder.path());
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_THAT(blocks("import m.dxf --map --layer b=3", folder.path()).err,
              HasSubstr("no line has the layer 'b'"));
  EXPECT_THAT(blocks("import m.dxf --map --layer a=x", folder.path()).err,
              HasSubstr("expected NAME=ID, NAME=outline or NAME=skip"));
}

std::string deck_with(const std::string& cards, const std::string& units = "") {
  return "START, 50, 20\nMAP\nXLIMITS, -1, 5\nYLIMITS, -1, 5\nBOXES, 2, 2, .1\nSTIFF, "
         "1.E8, 1.E8\n" +
         units + "MATERIAL, 1, 1.E10, 4.E9, 2500\nRIGID\nEND\n" + cards + "STOP\n";
}

TEST(Map, FilesOfCardsAreRefusedWithTheirLayers) {
  const TemporaryFolder folder;
  folder.write("m.dxf", map_of_beds());
  const auto check = [&folder](const std::string& cards) {
    folder.write("d.deck", deck_with(cards));
    const Outcome outcome = blocks("check d.deck", folder.path());
    EXPECT_EQ(outcome.code, 3);
    return outcome.err;
  };
  EXPECT_THAT(
      check("OUTLINE, , 1, m.dxf, boundary\nTRACES, m.dxf, 1, , bed\nCUT\n"),
      HasSubstr("d.deck:11:21: error: TRACES: m.dxf: no trace has the layer 'bed'"));
  EXPECT_THAT(check("OUTLINE, , 1, m.dxf, border\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("d.deck:10:22: error: OUTLINE: m.dxf: no polygon has the layer "
                        "'border'"));
  EXPECT_THAT(check("OUTLINE, 4, 1, m.dxf\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("both nc and a file are given"));
  EXPECT_THAT(check("OUTLINE, , 1\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("no corners are given"));
  EXPECT_THAT(check("OUTLINE, , 1, no.dxf\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("d.deck:10:15: error: OUTLINE: cannot read no.dxf"));
  EXPECT_THAT(check("OUTLINE, , 1, d.deck\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("the file is not GeoJSON, WKT or DXF"));
  EXPECT_THAT(check("OUTLINE, , 1, m.dxf\n1., 2., 3.\nTRACES, m.dxf\nCUT\n"),
              HasSubstr("unexpected line of values after this card"));
}

// A polygon of a mapping program runs anticlockwise, which is no mistake there.
TEST(Map, OutlinesOfFilesRunEitherWay) {
  const TemporaryFolder folder;
  for (const char* ring : {"0 0, 4 0, 4 4, 0 4, 0 0", "0 0, 0 4, 4 4, 4 0, 0 0"}) {
    folder.write("o.wkt", fmt::format("POLYGON (({}))", ring));
    folder.write("d.deck", deck_with("OUTLINE, , 1, o.wkt\nJSET, 1, 30, , 1\nCUT\n"));
    const Outcome check = blocks("check d.deck", folder.path());
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_THAT(check.err, Not(HasSubstr("anticlockwise")));
  }
}

TEST(Map, WarnsOfUnitsThatDiffer) {
  const TemporaryFolder folder;
  folder.write("m.dxf", map_of_beds(4));
  const std::string cards = "OUTLINE, , 1, m.dxf, boundary\nTRACES, m.dxf, 1\nCUT\n";
  folder.write("d.deck", deck_with(cards, "UNITS, m, kg, s\n"));
  const Outcome check = blocks("check d.deck", folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.err,
              AllOf(HasSubstr("warning: OUTLINE: the drawing is in mm ($INSUNITS), the "
                              "deck in m (UNITS)"),
                    HasSubstr("warning: TRACES: the drawing is in mm")));
  folder.write("d.deck", deck_with(cards, "UNITS, mm, kg, s\n"));
  EXPECT_THAT(blocks("check d.deck", folder.path()).err, Not(HasSubstr("INSUNITS")));
}

TEST(Map, ARestartKnowsThatTheFileOfItsOutlineHasChanged) {
  const TemporaryFolder folder;
  folder.write("o.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  folder.write("d.deck",
               deck_with("OUTLINE, , 1, o.wkt\nJSET, 1, 30, , 1\nCUT\nCYCLE, 20\n"));
  ASSERT_EQ(blocks("run d.deck -q --stop-after 10", folder.path()).code, 75);
  folder.write("o.wkt", "POLYGON ((0 0, 4 0, 4 4.5, 0 4, 0 0))");
  const Outcome again = blocks("run d.deck -q --restart d.ckpt.h5", folder.path());
  EXPECT_EQ(again.code, 5);
  EXPECT_THAT(again.err,
              HasSubstr("a file that READ9, OUTLINE, TRACES or VORONOI reads"));
}

TEST(Map, ExportsDrawingsThatComeBack) {
  const TemporaryFolder folder;
  folder.write("m.dxf", map_of_beds());
  ASSERT_EQ(blocks("import m.dxf --map --layer grid=skip", folder.path()).code, 0);
  ASSERT_EQ(blocks("export m.deck -o b.dxf", folder.path()).code, 0);
  const Outcome back = blocks("import b.dxf -o b.mesh.txt", folder.path());
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_THAT(back.out, HasSubstr("6 polygons"));
  ASSERT_EQ(blocks("export m.deck -o m.svg --scale 50", folder.path()).code, 0);
  // 4 m at 1:50 are 80 mm, with 8 mm on both sides.
  EXPECT_THAT(slurp(folder / "m.svg"),
              AllOf(HasSubstr("width=\"96mm\" height=\"106mm\""),
                    HasSubstr("id=\"joint-7\""), HasSubstr("1:50")));
}

}  // namespace
}  // namespace blocks::testing
