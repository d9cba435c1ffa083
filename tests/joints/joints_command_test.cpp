// `blocks joints` as a user calls it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* window = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\n";
constexpr const char* traces = "LINESTRING (1 5, 9 5)\nLINESTRING (3 2, 3 8)\n"
                               "LINESTRING (6 5.01, 6 9)\n";

void write_map(const TemporaryFolder& folder) {
  folder.write("map.wkt", traces);
  folder.write("window.wkt", window);
}

TEST(JointsCommand, CountsNodesOfAMap) {
  const TemporaryFolder folder;
  write_map(folder);
  const Outcome raw =
      blocks("joints statistics map.wkt --outline window.wkt --json", folder.path());
  ASSERT_EQ(raw.code, 0) << raw.err;
  const auto nodes = nlohmann::json::parse(raw.out)["maps"][0]["nodes"];
  EXPECT_EQ(nodes["i"], 6);
  EXPECT_EQ(nodes["x"], 1);
  const Outcome joined =
      blocks("joints statistics map.wkt --outline window.wkt --snap .02 --json",
             folder.path());
  const auto map = nlohmann::json::parse(joined.out)["maps"][0];
  EXPECT_EQ(map["nodes"]["i"], 5);
  EXPECT_EQ(map["nodes"]["y"], 1);
  EXPECT_EQ(map["area"], 100.0);
}

TEST(JointsCommand, ComparesAMapWithADeck) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string deck = BLOCKS_SOURCE_DIR "/decks/slope/slope.deck";
  const Outcome both = blocks(
      "joints statistics map.wkt " + deck + " --outline window.wkt", folder.path());
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_THAT(both.out, HasSubstr("slope.deck"));
  EXPECT_THAT(both.out, HasSubstr("area of the window [L2]"));
  const Outcome json =
      blocks("joints statistics map.wkt " + deck + " --outline window.wkt -o both.json",
             folder.path());
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(slurp(folder / "both.json"))["maps"].size(), 2U);
}

// The bends of a polyline are no nodes, in a deck as in a file.
TEST(JointsCommand, APolylineIsOneTraceInADeckToo) {
  const TemporaryFolder folder;
  folder.write("bent.wkt", "LINESTRING (1.1 5.3, 3.7 5.9, 6.3 4.7, 8.9 5.1)\n");
  folder.write("d.deck", "START, 9, 9\nBENT\nXLIMITS, -1, 11\nYLIMITS, -1, 11\nBOXES, "
                         "2, 2, .1\nSTIFF, 1.E8, 1.E8\nMATERIAL, 1, 1.E10, 4.E9, "
                         "2500\nRIGID\nEND\nOUTLINE, 4, 1\n0, 0, 10, 10\n0, 10, 10, "
                         "0\nTRACES, bent.wkt, 1\nCUT\nSTOP\n");
  const Outcome deck = blocks("joints statistics d.deck --json", folder.path());
  ASSERT_EQ(deck.code, 0) << deck.err;
  EXPECT_EQ(deck.err, "");
  const auto map = nlohmann::json::parse(deck.out)["maps"][0];
  EXPECT_EQ(map["nodes"]["i"], 2);
  EXPECT_EQ(map["branches"]["number"], 1.0);
}

// The joints of a deck are those before they are cut: P21 is that of the report of CUT.
TEST(JointsCommand, TheDensityOfADeckIsThatOfItsCut) {
  const TemporaryFolder folder;
  const std::string deck = BLOCKS_SOURCE_DIR "/decks/slope/slope.deck";
  const Outcome json = blocks("joints statistics " + deck + " --json", folder.path());
  const auto map = nlohmann::json::parse(json.out)["maps"][0];
  const Outcome check = blocks("check " + deck, folder.path());
  const double p21 = map["traces"]["density"]["p21"]["value"];
  EXPECT_THAT(check.out, HasSubstr(fmt::format("length per area {:.6g},", p21)));
  const Outcome other =
      blocks("joints statistics " + deck + " --seed 8 --json", folder.path());
  EXPECT_NE(json.out, other.out);
}

// The values that fractopo's own tests expect for these data, with the same snap
// (tests/data/krakfjarden).
TEST(JointsCommand, KrakfjardenAsFractopoCountsIt) {
  const TemporaryFolder folder;
  const std::string data = BLOCKS_SOURCE_DIR "/tests/data/krakfjarden/";
  const Outcome told = blocks("joints statistics " + data + "traces.wkt --outline " +
                                  data + "window.wkt --snap 0.001 --json",
                              folder.path());
  ASSERT_EQ(told.code, 0) << told.err;
  const auto map = nlohmann::json::parse(told.out)["maps"][0];
  EXPECT_EQ(map["nodes"]["i"], 476);
  EXPECT_EQ(map["nodes"]["y"], 826);
  EXPECT_EQ(map["nodes"]["x"], 268);
  EXPECT_EQ(map["nodes"]["e"], 114);
  const auto& branches = map["branches"];
  EXPECT_EQ(branches["number"], 2013.0);
  EXPECT_EQ(branches["c_c"], 1521);
  EXPECT_EQ(branches["c_i"], 408);
  EXPECT_EQ(branches["i_i"], 28);
  EXPECT_EQ(branches["cut_by_window"], 113);  // C-E 100, I-E 12, E-E 1
  const auto& length_per_area = map["traces"]["density"];
  EXPECT_EQ(map["traces"]["number"], 651.0);
  const std::vector<std::pair<double, double>> values = {
      {map["area"], 1237.9},
      {length_per_area["p20"]["value"], 0.53},
      {length_per_area["p21"]["value"], 1.26},
      {branches["b20"], 1.63},
      {branches["b22"], 0.98},
      {branches["mean_length"], 0.78},
      {branches["connections_per_branch"], 1.76},
      {map["traces"]["connections_per_trace"], 3.36}};
  for (const auto& [found, published] : values)
    EXPECT_NEAR(found, published, 0.005001);  // published with two decimals
}

TEST(JointsCommand, WithoutAWindowItWarns) {
  const TemporaryFolder folder;
  write_map(folder);
  const Outcome told = blocks("joints statistics map.wkt", folder.path());
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(told.err, HasSubstr("the window is the box of the traces"));
  EXPECT_THAT(told.err, HasSubstr("--outline FILE"));
}

TEST(JointsCommand, ScanlinesOfTheUser) {
  const TemporaryFolder folder;
  write_map(folder);
  const Outcome told =
      blocks("joints statistics map.wkt --outline window.wkt --scanline "
             "0,7,10,7 --scanline 0,3,10,3 --json",
             folder.path());
  ASSERT_EQ(told.code, 0) << told.err;
  const auto lines = nlohmann::json::parse(told.out)["maps"][0]["scanlines"]["given"];
  EXPECT_EQ(lines[0]["crossings"], 2);
  EXPECT_EQ(lines[0]["mean_spacing"], 3.0);
  EXPECT_EQ(lines[1]["crossings"], 1);
}

TEST(JointsCommand, AFittedDeckIsAcceptedAndNothingIsOverwritten) {
  const TemporaryFolder folder;
  folder.write("made.deck", slurp(BLOCKS_SOURCE_DIR "/decks/slope/slope.deck"));
  const Outcome fit = blocks("joints fit made.deck", folder.path());
  ASSERT_EQ(fit.code, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("written: made_fit.deck"));
  const std::string deck = slurp(folder / "made_fit.deck");
  EXPECT_THAT(deck, HasSubstr("\nJSET, 1, 35, 0, "));
  EXPECT_THAT(deck, HasSubstr("\nJSET, 2, 10"));
  const Outcome check = blocks("check made_fit.deck", folder.path());
  EXPECT_EQ(check.code, 0);
  EXPECT_EQ(check.err, "");
  // A second fit keeps the first deck.
  EXPECT_EQ(blocks("joints fit made.deck --seed 9", folder.path()).code, 0);
  EXPECT_EQ(slurp(folder / "made_fit.deck.bak"), deck);
  const Outcome same = blocks("joints fit made.deck -o made.deck", folder.path());
  EXPECT_EQ(same.code, 2);
  EXPECT_THAT(same.err, HasSubstr("would overwrite an input"));
}

TEST(JointsCommand, FitAsJson) {
  const TemporaryFolder folder;
  const Outcome fit =
      blocks("joints fit " BLOCKS_SOURCE_DIR "/decks/slope/slope.deck -o a.deck --json",
             folder.path());
  ASSERT_EQ(fit.code, 0) << fit.err;
  const auto sets = nlohmann::json::parse(fit.out)["sets"];
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_NEAR(sets[0]["dip"]["value"].get<double>(), 35.0, 1e-6);
  EXPECT_LE(sets[1]["trace"]["low"].get<double>(), 9.0);
  EXPECT_GE(sets[1]["trace"]["high"].get<double>(), 9.0);
}

TEST(JointsCommand, WrongInput) {
  const TemporaryFolder folder;
  write_map(folder);
  folder.write("two.wkt", std::string(window) + window);
  folder.write("bow.wkt", "POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))\n");
  folder.write("far.wkt", "POLYGON ((90 0, 91 0, 91 1, 90 1, 90 0))\n");
  folder.write("empty.deck",
               preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 10\nSTOP\n");
  folder.write("bad.deck", "OUTLINE, 4, 1\n0, 0, 10, 10\n0, 10, 10, 0\nCUT\n");
  folder.write("flat.wkt", "LINESTRING (0 0, 1 0)\n");
  struct Case {
    const char* words;
    int code;
    const char* message;
  };
  for (const Case& one : std::vector<Case>{
           {"joints", 2, "subcommand"},
           {"joints statistics", 2, "INPUT is required"},
           {"joints statistics none.wkt", 5, "none.wkt"},
           {"joints statistics window.wkt", 3, "window.wkt:1:"},
           {"joints statistics map.wkt --outline map.wkt", 3, "map.wkt:1:"},
           {"joints statistics map.wkt --outline two.wkt", 3, "2 polygons"},
           {"joints statistics map.wkt --outline bow.wkt", 3, "cross"},
           {"joints statistics map.wkt --outline far.wkt", 2, "no trace is inside"},
           {"joints statistics flat.wkt", 2, "no area"},
           {"joints statistics empty.deck", 3, "has no joints"},
           {"joints statistics bad.deck", 3, "bad.deck:"},
           {"joints statistics map.wkt --snap -1", 2, "length of 0 or more"},
           {"joints statistics map.wkt --snap nan", 2, "length of 0 or more"},
           {"joints statistics map.wkt --scanline 0,0,1", 2, "--scanline"},
           {"joints statistics map.wkt --scanline 1,1,1,1", 2, "two different points"},
           {"joints statistics map.wkt -o map.csv", 2, ".json"},
           {"joints fit map.wkt far.wkt", 2, "INPUT"},
           {"joints fit map.wkt -o map.wkt", 2, ".deck"},
       }) {
    const Outcome told = blocks(one.words, folder.path());
    EXPECT_EQ(told.code, one.code) << one.words << '\n' << told.err;
    EXPECT_THAT(told.err, HasSubstr(one.message)) << one.words;
  }
}

// Numbers and text are the same in every call.
TEST(JointsCommand, IsReproducible) {
  const TemporaryFolder folder;
  const std::string words =
      "joints statistics " BLOCKS_SOURCE_DIR "/decks/slope/slope.deck";
  EXPECT_EQ(blocks(words, folder.path()).out, blocks(words, folder.path()).out);
}

}  // namespace
}  // namespace blocks::testing
