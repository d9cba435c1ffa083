// The report of `blocks check --geometry`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

// Block 1 is a base. Blocks 2 and 3 overlap by a quarter of a unit square. Block 4 is
// 0.0004 above the base.
const std::string overlapping = preliminary() + rectangle(-4, -1, 4, 0, true) +
                                rectangle(0, 0, 2, 1) + rectangle(1.5, 0.5, 3.5, 1.5) +
                                rectangle(-3, 0.0004, -1, 1) + "CYCLE, 3\n";

Json geometry_json(const TemporaryFolder& folder, const std::string& deck, int code) {
  folder.write("a.deck", deck);
  const Outcome check = blocks("check --geometry --json a.deck", folder.path());
  EXPECT_EQ(check.code, code) << check.err;
  return Json::parse(check.out);
}

TEST(GeometryReport, NamesTheBlocksThatOverlap) {
  const TemporaryFolder folder;
  const Json json = geometry_json(folder, overlapping, 3);
  const Json& certificate = json["certificate"];
  EXPECT_FALSE(certificate["holds"].get<bool>());
  ASSERT_EQ(certificate["overlaps"].size(), 1U);
  EXPECT_EQ(certificate["overlaps"][0]["blocks"], Json({2, 3}));
  EXPECT_DOUBLE_EQ(certificate["overlaps"][0]["area"].get<double>(), 0.25);
  EXPECT_EQ(certificate["overlaps"][0]["place"], Json({1.75, 0.75}));
}

// A run accepts overlaps of the deck, because they carry no force.
TEST(GeometryReport, IsKeptInSummaryAndListingOfARun) {
  const TemporaryFolder folder;
  const Json json = geometry_json(folder, overlapping, 3);
  const Json& certificate = json["certificate"];
  run_text(folder, "a", overlapping);
  const Json kept = summary(folder, "a")["certificate"];
  EXPECT_FALSE(kept["holds"].get<bool>());
  EXPECT_EQ(kept["overlapping_pairs"], 1);
  EXPECT_EQ(kept["overlaps"], certificate["overlaps"]);
  EXPECT_EQ(kept["gap_count"], 1);
  EXPECT_EQ(kept["gaps"], json["gaps"]);
  const std::string gap = "1 gap, the widest 0.0004 between blocks 1 and 4 at (-1, "
                          "0.0004); 2 T-junctions\n";
  EXPECT_THAT(slurp(folder / "a.out"),
              HasSubstr("certificate: 1 pair of 4 blocks overlaps, most of all 2 and 3 "
                        "by an area of 0.25\n  " +
                        gap +
                        "  overlaps\n    blocks 2 and 3: area 0.25 near (1.75, 0.75)\n"
                        "  gaps, the widest first\n"
                        "    blocks 1 and 4: width 0.0004 at (-1, 0.0004)\n"));
  EXPECT_THAT(blocks("check a.deck", folder.path()).out, HasSubstr("\n" + gap));
}

// There are 4005 pairs of 90 equal blocks in one place.
TEST(GeometryReport, NamesAHundredPairsAndCountsTheRest) {
  const TemporaryFolder folder;
  run_text(folder, "a",
           preliminary() + "CLOOP, 90, 0, 0\n" + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  const Json kept = summary(folder, "a")["certificate"];
  EXPECT_EQ(kept["overlapping_pairs"], 90 * 89 / 2);
  EXPECT_EQ(kept["overlaps"].size(), 100U);
  EXPECT_THAT(slurp(folder / "a.out"), HasSubstr("    and 3905 more\n"));
}

// Overlaps of blocks that have moved are contacts and no faults of the deck. Blocks
// made after motion, or after a RESTART, are compared with the present positions.
TEST(GeometryReport, ComparesLaterBlocksWithPresentPositions) {
  const TemporaryFolder folder;
  const std::string settled = preliminary() + rectangle(-4, -1, 4, 0, true) +
                              rectangle(0, 0, 1, 1) + "GRAVITY, 0, -9.81\nCYCLE, 20\n";
  const std::string later = rectangle(-3, 0, -2, 1) + rectangle(-2.5, 0, -1.5, 1);
  const Outcome whole =
      run_text(folder, "whole", settled + later + "CYCLE, 20\nSTOP\n");
  EXPECT_EQ(whole.err.find("1 and 2 overlap"), std::string::npos) << whole.err;
  run_text(folder, "first", settled + "STOP\n");
  run_text(folder, "still", "RESTART, first.ckpt.h5\nSTOP\n");
  const Json still = summary(folder, "still")["certificate"];
  EXPECT_TRUE(still["holds"].get<bool>());
  EXPECT_EQ(still["moved_blocks"], 2);
  EXPECT_EQ(still["contacts"][0]["blocks"], Json({1, 2}));
  EXPECT_EQ(still["verdict"], "no two of 2 blocks overlap; all blocks have moved, "
                              "overlaps between them are contacts: 1 pair");
  run_text(folder, "second", "RESTART, first.ckpt.h5\n" + later + "CYCLE, 20\nSTOP\n");
  run_text(folder, "last",
           settled + later + "STOP\n");  // The last blocks make no step.
  for (const char* name : {"whole", "second", "last"}) {
    const Json kept = summary(folder, name)["certificate"];
    EXPECT_EQ(kept["blocks"], 4) << name;
    EXPECT_EQ(kept["moved_blocks"], 2) << name;
    ASSERT_EQ(kept["overlaps"].size(), 1U) << name;
    EXPECT_EQ(kept["overlaps"][0]["blocks"], Json({3, 4})) << name;
    EXPECT_THAT(slurp(folder / (std::string(name) + ".out")),
                HasSubstr("certificate: 1 pair of 4 blocks overlaps"));
  }
}

TEST(GeometryReport, FindsGapsAndTJunctions) {
  const TemporaryFolder folder;
  const Json json = geometry_json(folder, overlapping, 3);
  EXPECT_EQ(json["t_junctions"].size(), 2);  // Block 2 is on the base.
  ASSERT_EQ(json["gaps"].size(), 1U);
  EXPECT_EQ(json["gaps"][0]["blocks"], Json({1, 4}));
  EXPECT_DOUBLE_EQ(json["widest_gap"].get<double>(), 0.0004);
}

TEST(GeometryReport, TextAndJsonAgree) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() +
                           "MERGE, 0.5\n"
                           "ORIENT, -45, 45\n"
                           "LAYER, -20, 1, -9, -9, -9, -7, 9, -6.5, 9, -9, RANDOM\n" +
                           rectangle(-1, 0, 1, 1) + "CYCLE, 1\n";
  const Json json = geometry_json(folder, deck, 0);
  const std::string text = blocks("check --geometry a.deck", folder.path()).out;
  EXPECT_TRUE(json["certificate"]["holds"].get<bool>());
  EXPECT_THAT(text, StartsWith(fmt::format("a.deck: {} blocks, {} corners\n",
                                           json["blocks"].get<int>(),
                                           json["corners"].get<int>())));
  for (const auto& [key, name] :
       {std::pair{"area", "area"}, std::pair{"aspect_ratio", "aspect ratio"},
        std::pair{"shortest_side", "shortest side"},
        std::pair{"smallest_angle", "smallest angle, deg"}}) {
    const Json& measure = json[key];
    EXPECT_THAT(text, HasSubstr(fmt::format("  {:<22}{:>13.6g}{:>13.6g}{:>13.6g}\n",
                                            name, measure["smallest"].get<double>(),
                                            measure["median"].get<double>(),
                                            measure["largest"].get<double>())));
    long blocks_in_classes = 0;
    for (const Json& count : measure["classes"]["blocks"])
      blocks_in_classes += count.get<long>();
    EXPECT_EQ(blocks_in_classes, json["blocks"].get<long>());
    for (const Json& worst : measure["worst"])
      if (std::string(key) != "area") {
        EXPECT_THAT(text, HasSubstr(fmt::format("{:>12.6g}  block {}",
                                                worst["value"].get<double>(),
                                                worst["block"].get<int>())));
      }
  }
  ASSERT_FALSE(json["merges"].empty());
  for (const Json& merge : json["merges"])
    EXPECT_THAT(text, HasSubstr(fmt::format(
                          "layer 1: MERGE: block {} absorbed by {} (counted "
                          "within the layer before MERGE), width/height {:.6g} < 0.5",
                          merge["absorbed"].get<int>(), merge["into"].get<int>(),
                          merge["width_to_height"].get<double>())));
  const Json& layer = json["layers"][0];
  EXPECT_THAT(text, HasSubstr(fmt::format("{} cells, {} shared and {} outline sides",
                                          layer["cells"].get<int>(),
                                          layer["interior_edges"].get<int>(),
                                          layer["outline_edges"].get<int>())));
  EXPECT_GT(layer["sides_redrawn"].get<int>(), 0);
  EXPECT_THAT(text,
              HasSubstr(fmt::format(
                  "ORIENT: {} angles of {} sides redrawn, {} sides ruled",
                  layer["angles_redrawn"].get<int>(), layer["sides_redrawn"].get<int>(),
                  layer["sides_ruled"].get<int>())));
  EXPECT_THAT(text, HasSubstr("proved: no two of "));
}

// Far from the origin doubles are too coarse for small blocks.
TEST(GeometryReport, WarnsOfBlocksFarFromTheOrigin) {
  const TemporaryFolder folder;
  const auto deck = [](const std::string& x) {
    std::string cards = preliminary();
    cards.replace(cards.find("-10, 10"), 7, "0, 1.E9");  // These are the XLIMITS.
    return cards + fmt::format("CREATE, 4, 1\n{0}.25, {0}.25, {0}.5, {0}.5\n"
                               "0, 0.25, 0.25, 0\n",
                               x);
  };
  EXPECT_TRUE(geometry_json(folder, deck("1"), 0)["resolution"]["sufficient"]);
  const Json far = geometry_json(folder, deck("10000000"), 0)["resolution"];
  EXPECT_FALSE(far["sufficient"]);
  EXPECT_DOUBLE_EQ(far["ulp_over_shortest_side"].get<double>(), 0x1p-29 / 0.25);
  EXPECT_THAT(blocks("check --geometry a.deck", folder.path()).out,
              HasSubstr("move the origin of the deck near the blocks"));
}

TEST(GeometryReport, DrawsFaultyPlaces) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  EXPECT_EQ(blocks("check --geometry -q --plot a.svg a.deck", folder.path()).code, 3);
  const std::string svg = slurp(folder / "a.svg");
  EXPECT_THAT(svg, StartsWith("<?xml"));
  // These are the colours of overlaps, gaps, T-junctions and short sides.
  for (const char* colour : {"84%,10%,11%", "3%,38%,72%", "0%,50%,42%", "42%,26%,10%"})
    EXPECT_NE(svg.find(colour), std::string::npos) << colour;
}

TEST(GeometryReport, KeepsAnOlderFigure) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  folder.write("a.svg", "older");
  EXPECT_EQ(blocks("check --geometry -q --plot a.svg a.deck", folder.path()).code, 3);
  EXPECT_EQ(slurp(folder / "a.svg.bak"), "older");
}

TEST(GeometryReport, RefusesOtherFormatsOfAFigure) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  const Outcome gif = blocks("check --geometry -q --plot a.gif a.deck", folder.path());
  EXPECT_EQ(gif.code, 5);
  EXPECT_THAT(gif.err, HasSubstr(".png, .svg or .pdf, found 'a.gif'"));
}

TEST(GeometryReport, OptionsAreRefusedWithoutTheReport) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  for (const char* option : {"--json", "--plot a.png"})
    EXPECT_EQ(blocks(std::string("check a.deck ") + option, folder.path()).code, 2);
}

TEST(GeometryReport, IsNotMadeForAFaultyDeck) {
  const TemporaryFolder folder;
  folder.write("bad.deck", "START\n");
  EXPECT_EQ(blocks("check --geometry bad.deck", folder.path()).code, 3);
}

}  // namespace
}  // namespace blocks::testing
