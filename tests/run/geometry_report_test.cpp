// `blocks check --geometry` as a user sees it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

// A base, two blocks that share a quarter of a unit square, and one that hangs 0.0004
// above the base.
const std::string overlapping = preliminary() + rectangle(-4, -1, 4, 0, true) +
                                rectangle(0, 0, 2, 1) + rectangle(1.5, 0.5, 3.5, 1.5) +
                                rectangle(-3, 0.0004, -1, 1) + "CYCLE, 3\n";

Json geometry_json(const TemporaryFolder& folder, const std::string& deck, int code) {
  folder.write("a.deck", deck);
  const Outcome check = blocks("check --geometry --json a.deck", folder.path());
  EXPECT_EQ(check.code, code) << check.err;
  return Json::parse(check.out);
}

// Blocks that overlap fail the certificate: exit 3, and the pair, its area and place.
// A run goes on, since such an overlap carries no force, and keeps the verdict.
TEST(GeometryReport, NamesTheBlocksThatOverlap) {
  const TemporaryFolder folder;
  const Json json = geometry_json(folder, overlapping, 3);
  const Json& certificate = json["certificate"];
  EXPECT_FALSE(certificate["holds"].get<bool>());
  ASSERT_EQ(certificate["overlaps"].size(), 1U);
  EXPECT_EQ(certificate["overlaps"][0]["blocks"], Json({2, 3}));
  EXPECT_DOUBLE_EQ(certificate["overlaps"][0]["area"].get<double>(), 0.25);
  EXPECT_EQ(certificate["overlaps"][0]["place"], Json({1.75, 0.75}));

  run_text(folder, "a", overlapping);
  const Json kept = summary(folder, "a")["certificate"];
  EXPECT_FALSE(kept["holds"].get<bool>());
  EXPECT_EQ(kept["overlapping_pairs"], 1);
  EXPECT_THAT(slurp(folder / "a.out"),
              HasSubstr("certificate: 1 pair of 4 blocks overlaps"));
}

TEST(GeometryReport, FindsGapsAndTJunctions) {
  const TemporaryFolder folder;
  const Json json = geometry_json(folder, overlapping, 3);
  EXPECT_EQ(json["t_junctions"].size(), 2);  // block 2 on the base
  ASSERT_EQ(json["gaps"].size(), 1U);
  EXPECT_EQ(json["gaps"][0]["blocks"], Json({1, 4}));
  EXPECT_DOUBLE_EQ(json["widest_gap"].get<double>(), 0.0004);
}

// The text says what the JSON says.
TEST(GeometryReport, TextAndJsonAgree) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() +
                           "MERGE, 0.5\n"
                           "ORIENT, -15, 15\n"
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
  EXPECT_THAT(text, HasSubstr("proved: no two of "));
}

// Far from the origin doubles are too coarse for small blocks, and the report says what
// to do about it.
TEST(GeometryReport, WarnsFarFromTheOrigin) {
  const TemporaryFolder folder;
  const auto deck = [](const std::string& x) {
    std::string cards = preliminary();
    cards.replace(cards.find("-10, 10"), 7, "0, 1.E9");  // XLIMITS
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

// The figure shows the overlap, and an older figure is kept.
TEST(GeometryReport, DrawsTheOffendingPlaces) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  folder.write("a.svg", "older");
  EXPECT_EQ(blocks("check --geometry -q --plot a.svg a.deck", folder.path()).code, 3);
  EXPECT_EQ(slurp(folder / "a.svg.bak"), "older");
  const std::string svg = slurp(folder / "a.svg");
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_NE(svg.find("84%"), std::string::npos);  // the red of overlaps
  const Outcome gif = blocks("check --geometry -q --plot a.gif a.deck", folder.path());
  EXPECT_EQ(gif.code, 5);
  EXPECT_THAT(gif.err, HasSubstr(".png, .svg or .pdf"));
}

TEST(GeometryReport, OptionsNeedTheReport) {
  const TemporaryFolder folder;
  folder.write("a.deck", overlapping);
  for (const char* option : {"--json", "--plot a.png"})
    EXPECT_EQ(blocks(std::string("check a.deck ") + option, folder.path()).code, 2);
  folder.write("bad.deck", "START\n");
  EXPECT_EQ(blocks("check --geometry bad.deck", folder.path()).code, 3);
}

}  // namespace
}  // namespace blocks::testing
