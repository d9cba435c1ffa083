// The commands `blocks import` and `blocks export`.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exchange/block_record.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n";
const std::string overlapping = square + "POLYGON ((0.5 0, 2 0, 2 1, 0.5 1, 0.5 0))\n";

// The file extension has no meaning. Blanks and byte order marks are skipped.
TEST(Import, FindsTheFormatByContent) {
  const TemporaryFolder folder;
  folder.write("a.dat", "\n  " + square);
  folder.write("b.dat", "\xEF\xBB\xBF {\"type\": \"Polygon\", \"coordinates\": "
                        "[[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}");
  folder.write("c.dat", "$ text\nBLOCKS\n4, 1\n0, 0\n0, 1\n1, 1\n1, 0\n");
  for (const std::string name : {"a", "b", "c"}) {
    const Outcome import =
        blocks("import " + name + ".dat --material 1", folder.path());
    EXPECT_EQ(import.code, 0) << import.err;
    EXPECT_TRUE(folder.holds(name + ".mesh.txt"));
  }
  EXPECT_EQ(
      slurp(folder / "a.mesh.txt"),
      "$ From a.dat: WKT, 1 polygon.\nBLOCKS 1\n4, 1\n  0, 0\n  0, 1\n  1, 1\n  1, "
      "0\n");
}

TEST(Import, RefusesContentOfAnotherFormatThanTheOption) {
  const TemporaryFolder folder;
  folder.write("a.dat", "\n  " + square);
  EXPECT_EQ(blocks("import a.dat --format geojson", folder.path()).code, 3);
}

TEST(Import, RefusesOverlaps) {
  const TemporaryFolder folder;
  folder.write("two.wkt", overlapping);
  const Outcome refused = blocks("import two.wkt --material 1", folder.path());
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, StartsWith("two.wkt:1:1: error: WKT: blocks 1 and 2 overlap "
                                      "by an area of 0.5 near (0.75, 0.5)\n"));
  EXPECT_FALSE(folder.holds("two.mesh.txt"));
}

TEST(Import, ReportsOverlapsWithoutWriting) {
  const TemporaryFolder folder;
  folder.write("two.wkt", overlapping);
  const Outcome report = blocks("import two.wkt --report-only", folder.path());
  EXPECT_EQ(report.code, 0);
  EXPECT_THAT(report.err, HasSubstr("overlap by an area of 0.5"));
  EXPECT_FALSE(folder.holds("two.mesh.txt"));
}

TEST(Import, KeepsOverlapsIfToldTo) {
  const TemporaryFolder folder;
  folder.write("two.wkt", overlapping);
  const Outcome kept =
      blocks("import two.wkt --material 1 --keep-overlaps", folder.path());
  EXPECT_EQ(kept.code, 0);
  EXPECT_THAT(kept.err, StartsWith("two.wkt:1:1: warning: "));
  EXPECT_TRUE(folder.holds("two.mesh.txt"));
}

TEST(Import, KeepsOlderFiles) {
  const TemporaryFolder folder;
  folder.write("s.wkt", square);
  folder.write("s.mesh.txt", "mine\n");
  folder.write("s.deck", "mine too\n");
  EXPECT_EQ(blocks("import s.wkt --material 1 --deck", folder.path()).code, 0);
  EXPECT_EQ(slurp(folder / "s.mesh.txt.bak"), "mine\n");
  EXPECT_EQ(slurp(folder / "s.deck.bak"), "mine too\n");
  // Nothing is lost, however often the program writes, and nothing is kept twice.
  for (const char* text : {"mine, too\n", "mine again\n"}) {
    folder.write("s.mesh.txt", text);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(blocks("import s.wkt --material 1 --deck", folder.path()).code, 0);
  }
  EXPECT_EQ(slurp(folder / "s.mesh.txt.bak"), "mine\n");
  EXPECT_EQ(slurp(folder / "s.mesh.txt.bak2"), "mine, too\n");
  EXPECT_EQ(slurp(folder / "s.mesh.txt.bak3"), "mine again\n");
  EXPECT_FALSE(folder.holds("s.mesh.txt.bak4"));
}

TEST(Import, DoesNotOverwriteItsInput) {
  const TemporaryFolder folder;
  folder.write("s.wkt", square);
  EXPECT_EQ(blocks("import s.wkt --material 1 -o s.wkt", folder.path()).code, 2);
  EXPECT_EQ(slurp(folder / "s.wkt"), square);
}

// The output of -o is the mesh.
TEST(Import, SaysWhatTheOutputNamesIfItIsTheDeck) {
  const TemporaryFolder folder;
  folder.write("s.wkt", square);
  const Outcome import =
      blocks("import s.wkt --material 1 --deck -o new.deck", folder.path());
  EXPECT_EQ(import.code, 2);
  EXPECT_EQ(import.err,
            "blocks: error: -o names the mesh, and --deck writes new.deck beside it: "
            "choose a name for the mesh, such as -o new.mesh.txt\n");
}

/// Returns a GeoJSON file of one square for each name of a material, from material 1.
std::string squares_named(const std::vector<std::string>& names) {
  nlohmann::json file = {{"type", "FeatureCollection"},
                         {"features", nlohmann::json::array()}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double x = 2.0 * static_cast<double>(i);
    const nlohmann::json ring = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}, {x, 0}};
    file["features"].push_back(
        {{"type", "Feature"},
         {"properties", {{"material", i + 1}, {"material_name", names[i]}}},
         {"geometry",
          {{"type", "Polygon"}, {"coordinates", nlohmann::json::array({ring})}}}});
  }
  return file.dump();
}

TEST(Import, KeepsNamesOfMaterialsThatADeckCanHave) {
  const TemporaryFolder folder;
  folder.write("s.json", squares_named({"it's, $ y!", "say \"no\""}));
  const Outcome import = blocks("import s.json --deck", folder.path());
  EXPECT_EQ(import.code, 0);
  EXPECT_EQ(import.err, "");
  EXPECT_THAT(slurp(folder / "s.deck"), AllOf(HasSubstr("2500, \"it's, $ y!\"\n"),
                                              HasSubstr("2500, 'say \"no\"'\n")));
  const Outcome check = blocks("check s.deck", folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
}

TEST(Import, TellsOtherNamesInTheDeck) {
  const TemporaryFolder folder;
  folder.write("s.json",
               squares_named({"it's \"x\"", "new\nline", "a:max", "7", "it's  x "}));
  const Outcome import = blocks("import s.json --deck", folder.path());
  EXPECT_EQ(import.code, 0);
  for (const char* message : {"the name of material 1 is 'it's  x ' in the deck\n",
                              "the name of material 2 is 'new line' in the deck\n",
                              "the name of material 3 is 'a max' in the deck\n",
                              "the name of material 4 is 'material 7' in the deck\n",
                              "material 5 has no name in the deck, because another one "
                              "is named 'it's  x '\n"})
    EXPECT_THAT(import.err,
                HasSubstr(std::string("s.json: warning: GeoJSON: ") + message));
  const Outcome check = blocks("check s.deck", folder.path());
  EXPECT_EQ(check.code, 0) << check.err;
}

// Text of a file is shown without its control characters.
TEST(Import, ShowsANameWithALineBreakOnOneLine) {
  const TemporaryFolder folder;
  std::string text = squares_named({"new\nline", "other"});
  text.replace(text.find("\"material\":2"), 12, "\"material\":1");
  folder.write("s.json", text);
  EXPECT_THAT(blocks("import s.json", folder.path()).err,
              HasSubstr("material 1 has another name, new line, which is kept\n"));
}

TEST(Import, ReportsFilesThatItCannotReadOrWrite) {
  const TemporaryFolder folder;
  folder.write("s.wkt", square);
  EXPECT_EQ(blocks("import no.wkt", folder.path()).code, 5);
  EXPECT_EQ(blocks("import s.wkt --material 1 -o no/s.txt", folder.path()).code, 5);
}

// The areas are beyond the range of doubles.
TEST(Import, RefusesADeckWithAreasBeyondDoubles) {
  const TemporaryFolder folder;
  for (const char* size : {"1e300", "1e-300"}) {
    folder.write("s.wkt", fmt::format("POLYGON((0 0, {0} 0, 0 {0}, 0 0))", size));
    const Outcome import = blocks("import s.wkt --material 1 --deck", folder.path());
    EXPECT_EQ(import.code, 3);
    EXPECT_THAT(import.err, HasSubstr("for a deck; nothing written"));
    EXPECT_FALSE(folder.holds("s.deck") || folder.holds("s.mesh.txt"));
  }
}

// The blocks are near the origin, far away, or very small.
TEST(Import, WritesADeckThatRuns) {
  const TemporaryFolder folder;
  const std::string far = "POLYGON ((500000.25 4e6, 500000.5 4e6, 500000.5 4000000.25, "
                          "500000.25 4e6))";
  const std::string tiny = "POLYGON((0 0,1e-6 0,1e-6 2e-6,0 0))";
  for (const std::string& wkt : {square, far, tiny}) {
    folder.write("s.wkt", wkt);
    EXPECT_EQ(blocks("import s.wkt --material 12 --deck", folder.path()).code, 0);
    const Outcome check = blocks("check s.deck", folder.path());
    EXPECT_EQ(check.code, 0) << check.err;
    // The stiffness of the deck is far too large for a tiny block.
    EXPECT_EQ(check.err.find("very stiff") != std::string::npos, wkt == tiny);
    EXPECT_EQ(check.err.empty(), wkt != tiny);
    EXPECT_EQ(blocks("run s.deck -q", folder.path()).code, 0);
  }
}

TEST(Export, WritesAFrameOfResults) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           preliminary() + rectangle(0, 0, 2, 1) +
               "GRAVITY, 0, -10\nPLOTS, 0.1\nMOTION, 0.5\nSTOP\n");
  EXPECT_EQ(blocks("export fall.vtkhdf -o now.json", folder.path()).code, 0);
  EXPECT_EQ(blocks("export fall.vtkhdf -t 0 -o then.json", folder.path()).code, 0);
  const auto now = nlohmann::json::parse(slurp(folder / "now.json"));
  const auto then = nlohmann::json::parse(slurp(folder / "then.json"));
  EXPECT_EQ(then["time"], 0.0);
  EXPECT_NEAR(now["time"].get<double>(), 0.5, 1e-3);
  const auto& properties = now["features"][0]["properties"];
  const double time = now["time"].get<double>();
  EXPECT_NEAR(properties["speed"].get<double>(), 10 * time, 1e-9);
  EXPECT_NEAR(properties["displacement"].get<double>(), 5 * time * time, 0.01);
  for (const char* name : {"number", "material", "fixed", "area", "rotation", "s11",
                           "s12", "s22", "p1", "p2"})
    EXPECT_TRUE(properties.contains(name)) << name;
  const auto y = [](const nlohmann::json& file) {
    return file["features"][0]["geometry"]["coordinates"][0][0][1].get<double>();
  };
  EXPECT_NEAR(y(then) - y(now), properties["displacement"].get<double>(), 1e-9);
}

// Gmsh has no hexagons, so block 32 becomes triangles. $Blocks keeps its outline and
// which blocks are fixed.
TEST(Export, SetsFieldsOfADeck) {
  const TemporaryFolder folder;
  folder.write("a.deck", preliminary() + rectangle(0, 0, 2, 1) + "CYCLE, 1\n");
  EXPECT_EQ(blocks("export a.deck --set CREATE.mat=2 -o a.json", folder.path()).code,
            0);
  const auto json = nlohmann::json::parse(slurp(folder / "a.json"));
  EXPECT_EQ(json["features"][0]["properties"]["material"], 2);
  EXPECT_EQ(blocks("export a.deck --set CREATE.mat=7", folder.path()).code, 3);
  EXPECT_EQ(blocks("export a.deck --set CREATE", folder.path()).code, 2);
  ASSERT_EQ(blocks("run a.deck -q", folder.path()).code, 0);
  EXPECT_EQ(blocks("export a.vtkhdf --set CREATE.mat=2", folder.path()).code, 2);
}

TEST(Export, KeepsBlocksThatAreNoGmshElements) {
  const TemporaryFolder folder;
  const std::string deck = BLOCKS_SOURCE_DIR "/decks/every_card/every_card.deck";
  const Outcome msh = blocks("export " + deck + " -o a.msh", folder.path());
  EXPECT_EQ(msh.code, 0) << msh.err;
  EXPECT_THAT(msh.out, Not(HasSubstr("leaves out")));
  EXPECT_EQ(blocks("export " + deck + " -o a.geojson", folder.path()).code, 0);
  EXPECT_EQ(blocks("import a.msh -o b.mesh.txt --deck", folder.path()).code, 0);
  EXPECT_EQ(blocks("export b.deck -o b.geojson", folder.path()).code, 0);
  EXPECT_EQ(slurp(folder / "a.geojson"), slurp(folder / "b.geojson"));
}

// An outline that crosses itself has no triangles, so nothing is written.
TEST(Export, RefusesToGmshWhatCannotBeCut) {
  exchange::BlockRecord block;
  block.number = block.material = 7;
  block.outline = {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {-1, 1}};
  EXPECT_THROW(exchange::write_gmsh({block}), std::invalid_argument);
}

TEST(Export, SaysWhatTheFormatLeavesOut) {
  const TemporaryFolder folder;
  const std::string deck = BLOCKS_SOURCE_DIR "/decks/every_card/every_card.deck";
  EXPECT_THAT(blocks("export " + deck + " -o a.wkt", folder.path()).out,
              HasSubstr(".wkt leaves out materials, which blocks are fixed"));
}

TEST(Export, RefusesUnknownFormatsMissingFilesAndTimesOfADeck) {
  const TemporaryFolder folder;
  const std::string deck = BLOCKS_SOURCE_DIR "/decks/every_card/every_card.deck";
  EXPECT_EQ(blocks("export " + deck + " -o a.dwg", folder.path()).code, 2);
  EXPECT_EQ(blocks("export " + deck + " -t 1", folder.path()).code, 2);
  EXPECT_EQ(blocks("export no.deck", folder.path()).code, 5);
}

TEST(Help, OfImportAndExportHasExamplesThatRun) {
  for (const std::string command : {"import", "export"}) {
    const TemporaryFolder folder;
    const std::string help = blocks(command + " --help", folder.path()).out;
    const std::string begin = "\nExample: blocks ";
    const auto at = help.find(begin + command + " decks/");
    ASSERT_NE(at, std::string::npos) << help;
    const auto from = at + begin.size();
    std::string example = help.substr(from, help.find('\n', from) - from);
    example.replace(example.find("decks/"), 6, BLOCKS_SOURCE_DIR "/decks/");
    const Outcome outcome = blocks(example, folder.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(fs::is_empty(folder.path()));
  }
}

}  // namespace
}  // namespace blocks::testing
