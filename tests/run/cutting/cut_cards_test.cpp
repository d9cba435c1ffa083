// OUTLINE ... CUT as users see them: reports, shared sides, random streams, restarts,
// interrupts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "run/run.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The preliminary cards, with room for many blocks of many corners.
std::string start() {
  std::string cards = preliminary();
  cards.replace(0, cards.find('\n'), "START, 50000, 500");
  return cards;
}

/// A square of 10 x 10, cut by the joints.
std::string square(const std::string& joints, const std::string& cut = "CUT") {
  return "OUTLINE, 4, 1\n-5, -5, 5, 5\n-5, 5, 5, -5\n" + joints + "\n" + cut + "\n";
}

class CutCards : public ::testing::Test {
 protected:
  /// Returns the model of a deck with these cards, which must be sound.
  Model model_of(const std::string& cards, std::vector<deck::Override> sets = {}) {
    folder_.write("deck", start() + cards);
    run::RunOptions options;
    options.deck = (folder_ / "deck").string();
    options.overrides = std::move(sets);
    options.quiet = true;
    ::testing::internal::CaptureStderr();
    run::CheckedDeck checked = run::build_checked(options);
    const std::string messages = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(checked.code, 0) << messages;
    return std::move(checked.model);
  }
  TemporaryFolder folder_;
};

/// Returns the ends of all sides with this joint id, without direction.
std::set<std::array<double, 4>> sides_of(const Blocks& blocks, int joint) {
  std::set<std::array<double, 4>> sides;
  for (int c = 0; c < blocks.corners(); ++c) {
    std::array<double, 2> a{blocks.corner(0, c), blocks.corner(1, c)};
    std::array<double, 2> b{blocks.corner(0, blocks.next[c]),
                            blocks.corner(1, blocks.next[c])};
    if (b < a)
      std::swap(a, b);
    if (blocks.joint[c] == joint)
      sides.insert({a[0], a[1], b[0], b[1]});
  }
  return sides;
}

TEST_F(CutCards, OneLineMakesTwoBlocksWithItsId) {
  const Model model = model_of(square("JSET, 7, 0, 0, 100"));
  ASSERT_EQ(model.blocks.size(), 2);
  EXPECT_EQ(model.blocks.area[0], 50.0);
  EXPECT_EQ(model.blocks.area[1], 50.0);
  EXPECT_EQ(sides_of(model.blocks, 7),
            (std::set<std::array<double, 4>>{{-5.0, 0.0, 5.0, 0.0}}));
  EXPECT_EQ(std::count(model.blocks.joint.begin(), model.blocks.joint.end(), 0), 6);
  ASSERT_EQ(model.joint_lengths.size(), 1U);
  EXPECT_EQ(model.joint_lengths[0].joint, 7);
  EXPECT_DOUBLE_EQ(model.joint_lengths[0].drawn, 10.0);
  EXPECT_EQ(model.joint_lengths[0].pruned, 0.0);
}

TEST_F(CutCards, CheckReportsTheCut) {
  folder_.write("a.deck", start() + square("JSET, 1, 20, 3, 1, .2, 3, .5, .5, .2\n"
                                           "JSET, 2, 80, 3, 1, .2, 3, .5, .5, .2",
                                           "CUT, .05, .01"));
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.out,
              AllOf(HasSubstr("cut 1: blocks 1 to "), HasSubstr("tiling proved: "),
                    HasSubstr(", area 100\n"), HasSubstr("  joint 1: length "),
                    HasSubstr("  joint 2: length "), HasSubstr(" pruned\n"),
                    HasSubstr("overlap\nno gaps; ")));
  const Outcome geometry = blocks("check --geometry a.deck", folder_.path());
  EXPECT_THAT(geometry.out, HasSubstr("\nSides of blocks\n"));
  const auto json = nlohmann::json::parse(
      blocks("check --geometry --json a.deck", folder_.path()).out);
  long blocks_counted = 0;
  for (const auto& entry : json["sides"])
    blocks_counted += entry["blocks"].get<long>();
  EXPECT_EQ(blocks_counted, json["blocks"].get<long>());
  EXPECT_EQ(json["cuts"][0]["blocks"], json["blocks"]);
  const Outcome run = blocks("run a.deck -q", folder_.path());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(summary(folder_, "a")["cuts"], json["cuts"]);
  EXPECT_THAT(slurp(folder_ / "a.out"), HasSubstr("BLOCKS CUT ALONG JOINTS"));
}

TEST_F(CutCards, WarnsOfJointsThatDoNotCut) {
  folder_.write("a.deck", start() + square("JSET, 1, 0, 0, 100, 0, 1, 0, 9"));
  EXPECT_THAT(blocks("check a.deck", folder_.path()).err,
              HasSubstr("warning: CUT: the joints cut off no block\n"));
  folder_.write("b.deck", start() + square("JSET, 1, 0, 0, 100, 0, , , , , 0, 50\n"
                                           "JSET, 2, 0, 0, 6"));
  EXPECT_THAT(blocks("check b.deck", folder_.path()).err,
              HasSubstr("JSET: no joint of this set meets the outline\n"));
}

TEST_F(CutCards, AnticlockwiseOutlinesAreReversedWithAWarning) {
  folder_.write("a.deck", start() + "OUTLINE, 4, 1\n-5, 5, 5, -5\n-5, -5, 5, 5\n"
                                    "JSET, 1, 0, 0, 2\nCUT\n");
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("warning: OUTLINE: the corners run anticlockwise"));
}

TEST_F(CutCards, AChangedNumberOnOneCardMovesNoJointOfAnother) {
  const std::string cards =
      square("JSET, 1, 20, 5, 1, .5\nJSET, 2, 80, 5, 1, .5\nJSET, 1, 50, 9, 4, 1\n"
             "VORONOI, 9, 1, 3");
  const auto joints_of = [&](std::vector<deck::Override> sets) {
    return model_of(cards, std::move(sets)).joint_lengths;
  };
  const auto length = [](const std::vector<JointLengthRecord>& lengths, int joint) {
    return std::find_if(lengths.begin(), lengths.end(),
                        [&](const auto& one) { return one.joint == joint; })
        ->drawn;
  };
  const auto before = joints_of({});
  // The drawn length of a set does not depend on what else crosses it, up to round-off.
  const auto after = joints_of({{"JSET[2]", "space", "1.7"}, {"VORONOI", "n", "20"}});
  EXPECT_NEAR(length(after, 1), length(before, 1), 1e-9);
  EXPECT_GT(std::abs(length(after, 2) - length(before, 2)), 1.0);
  const auto third = joints_of({{"JSET[3]", "dip", "30"}});
  EXPECT_NEAR(length(third, 2), length(before, 2), 1e-9);
  EXPECT_NEAR(length(third, 3), length(before, 3), 1e-9);
}

// Beds are 2 apart and traces 5 long, so every cross joint reaches two beds, or a bed
// and the outline, and none passes a bed.
TEST_F(CutCards, CrossJointsStopAtBeds) {
  const std::string beds = "JSET, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0\n",
                    cross = "JSET, 2, 90, 0, 1, 0, 5, 0, 0, 0, 0.3, 0, UNIFORM";
  const auto sides = sides_of(model_of(square(beds + cross + ", 1")).blocks, 2);
  EXPECT_GE(sides.size(), 10U);
  for (const auto& side : sides) {
    EXPECT_EQ(side[0], side[2]);
    const double low = std::min(side[1], side[3]), high = std::max(side[1], side[3]);
    EXPECT_EQ(high - low, low == -5.0 || high == 5.0 ? 1.0 : 2.0);
  }
  // Without it, traces pass beds, and their loose ends are pruned between beds.
  EXPECT_GT(sides_of(model_of(square(beds + cross)).blocks, 2).size(), sides.size());
}

TEST_F(CutCards, RefusesTracesThatEndNowhere) {
  const std::string cross = "JSET, 2, 90, 0, 1, 0, 5, 0, 0, 0, 0.3, 0, UNIFORM, 1",
                    beds = "JSET, 1, 0, 0, 2";
  folder_.write("t.deck", start() + square(cross + "\n" + beds) + "CYCLE, 1\n");
  EXPECT_THAT(
      blocks("check t.deck", folder_.path()).err,
      AllOf(HasSubstr("t.deck:15:52: error: JSET: no joint above has the id 1\n"),
            HasSubstr("stand before this card in the group")));
  folder_.write("t.deck", start() +
                              square(beds + "\nJSET, 2, 90, 0, 1, 0, 0, 0, 0, 0, "
                                            "0, 0, UNIFORM, 1") +
                              "CYCLE, 1\n");
  EXPECT_THAT(blocks("check t.deck", folder_.path()).err,
              HasSubstr("error: JSET: until needs traces that end, and trace is 0\n"));
}

// Without protection, cleaning moves corners of the perimeter.
TEST_F(CutCards, ProtectsThePerimeterOfAnOpening) {
  folder_.write("opening.csv", "x1,y1,x2,y2\n-2,-2,-2,2\n-2,2,2,2\n2,2,2,-2\n2,-2,-2,"
                               "-2\n");
  const std::string joints = "TRACES, opening.csv, 9\nJSET, 1, 31, 9, .7, .3\n"
                             "JSET, 2, 117, 9, .9, .3";
  // The largest distance of an end of a side from the perimeter.
  const auto moved = [&](const std::string& cut) {
    double max = 0.0;
    const auto sides = sides_of(model_of(square(joints, cut)).blocks, 9);
    EXPECT_GE(sides.size(), 4U);
    for (const auto& [ax, ay, bx, by] : sides)
      for (const auto& [x, y] : {std::pair{ax, ay}, {bx, by}})
        max = std::max(max, std::abs(std::max(std::abs(x), std::abs(y)) - 2.0));
    return max;
  };
  EXPECT_LT(moved("CUT, .3, .1, 9"), 1e-15);
  EXPECT_GT(moved("CUT, .3, .1"), 1e-3);
  folder_.write("t.deck", start() + square(joints, "CUT, .3, .1, 8") + "CYCLE, 1\n");
  EXPECT_THAT(blocks("check t.deck", folder_.path()).err,
              HasSubstr("warning: CUT: no joint of the group has the id 8"));
}

TEST_F(CutCards, EqualSetsContinueInAnotherOutline) {
  const std::string set = "JSET, 1, 35, 6, 1, .3\n";
  const auto sides_at_border = [&](const Model& model) {
    std::set<double> heights;
    for (int c = 0; c < model.blocks.corners(); ++c)
      if (model.blocks.corner(0, c) == 0.0)
        heights.insert(model.blocks.corner(1, c));
    return heights;
  };
  const Model left = model_of("OUTLINE, 4, 1\n-5, -5, 0, 0\n-5, 5, 5, -5\n" + set +
                              "CUT\n"),
              right =
                  model_of("OUTLINE, 4, 2\n0, 0, 5, 5\n-5, 5, 5, -5\n" + set + "CUT\n");
  EXPECT_GT(sides_at_border(left).size(), 5U);
  EXPECT_EQ(sides_at_border(left), sides_at_border(right));
}

// Layers, blocks of CREATE and cut domains are neighbours across slanted lines. Corners
// are chosen in decimals, so most of them are not on the line in doubles.
TEST_F(CutCards, ShareSidesWithLayersAndBlocks) {
  std::mt19937 random(3);
  const auto decimal = [&](double low, double high) {
    return std::round(std::uniform_real_distribution(low, high)(random) * 1e3) / 1e3;
  };
  for (int i = 0; i < 40; ++i) {
    // A slanted line from a to b; a layer below it, two domains and a block above it.
    const double ax = -8, ay = decimal(-2, 2), bx = 8, by = decimal(-2, 2);
    const auto on_line = [&](int k) {  // exact in decimals: k of 16 parts
      return std::pair(fmt::format("{:.10f}", ax + (bx - ax) * k / 16),
                       fmt::format("{:.10f}", ay + (by - ay) * k / 16));
    };
    const auto point = [&](int k) { return on_line(k); };
    const int s = 3 + i % 4, t = 10 + i % 5;
    const double left = decimal(3, 5), middle = decimal(3, 5), right = decimal(3, 5),
                 end = decimal(3, 5);
    const char* below = i % 2 == 0 ? "LAYER, -4, 1, {0}, -9, {0}, {1:.10f}, {2}, "
                                     "{3:.10f}, {2}, -9, RANDOM\n"
                                   : "CREATE, 4, 1\n{0}, {0}, {2}, {2}\n-9, {1:.10f}, "
                                     "{3:.10f}, -9\n";
    std::string cards = fmt::format(fmt::runtime(below), ax, ay, bx, by);
    const auto domain = [&](std::pair<std::string, std::string> from, double top_from,
                            std::pair<std::string, std::string> to, double top_to,
                            const std::string& joints) {
      return fmt::format(
          "OUTLINE, 4, 2\n{0}, {0}, {1}, {1}\n{2}, {3}, {4}, {5}\n{6}CUT\n", from.first,
          to.first, from.second, top_from, top_to, to.second, joints);
    };
    cards += domain(point(0), left, point(s), middle,
                    "JSET, 1, 30, 10, .9, .4\nJSET, 2, 100, 10, 1.1, .5\n");
    cards += domain(point(s), middle, point(t), right, "VORONOI, 30, 1, 3\n");
    cards += fmt::format("CREATE, 4, 1\n{0}, {0}, {1}, {1}\n{2}, {3}, {4}, {5}\n",
                         point(t).first, bx, point(t).second, right, end, by);
    const Model model = model_of(cards);
    folder_.write("a.deck", start() + cards);
    const auto json = nlohmann::json::parse(
        blocks("check --geometry --json a.deck", folder_.path()).out);
    EXPECT_TRUE(json["certificate"]["holds"].get<bool>()) << cards;
    EXPECT_EQ(json["certificate"]["roundings"].size(), 0U) << cards;
    EXPECT_EQ(json["gaps"].size(), 0U) << cards;
    if (HasFailure())
      break;
  }
}

TEST_F(CutCards, GiveTheSameBitsForAnyThreadsAndAfterARestart) {
  const std::string deck =
      start() + rectangle(-9, -7, 9, -5, true) +
      square("JSET, 1, 30, 8, 1.5, .5\nJSET, 2, 110, 8, 2, .8, 5, 1, 1, .5",
             "CUT, .1, .05") +
      "GRAVITY, 0, -9.81\nFRICTN, .4\nDAMPING, .2\nCYCLE, 400\n" +
      "OUTLINE, 4, 2\n-9, -9, -6, -6\n0, 3, 3, 0\nVORONOI, 12\nCUT\nCYCLE, 400\n";
  folder_.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q -j1", folder_.path()).code, 0);
  const auto whole = left_by_run(folder_.path(), "a");
  const TemporaryFolder other;
  other.write("a.deck", deck);
  ASSERT_EQ(blocks("run a.deck -q -j2 --stop-after 170", other.path()).code, 75);
  ASSERT_EQ(
      blocks("run a.deck -q -j2 --restart a.ckpt.h5 --stop-after 400", other.path())
          .code,
      75);
  ASSERT_EQ(blocks("run a.deck -q -j1 --restart a.ckpt.h5", other.path()).code, 0);
  expect_same(left_by_run(other.path(), "a"), whole, "stopped in both motions");
  EXPECT_EQ(summary(other, "a")["cuts"].size(), 2U);
}

// 2e8 tracks of random spacing would lie between (0, 0) and this outline.
TEST_F(CutCards, SetsInNationalCoordinatesBeginAtTheOutline) {
  const fs::path deck =
      fs::path(BLOCKS_SOURCE_DIR) / "tests/corpus/networks/national_grid.deck";
  const Outcome check = blocks("check '" + deck.string() + "'", folder_.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.err, HasSubstr(":16:1: warning: JSET: the set starts at the first "
                                   "corner of the outline, (100000000, 100000000)"));
}

// 6e6 traces would lie between (0, 0) and this outline: fewer than one card may make,
// but more than a small machine has memory for.
TEST_F(CutCards, SetsOfTracesInNationalCoordinatesBeginAtTheOutline) {
  std::string cards = start();
  cards.replace(cards.find("XLIMITS"), cards.find("BOXES") - cards.find("XLIMITS"),
                "XLIMITS, 349900, 350200\nYLIMITS, 5599900, 5600200\n");
  folder_.write("a.deck", cards +
                              "OUTLINE, 4, 1\n350000, 350000, 350100, 350100\n"
                              "5600000, 5600100, 5600100, 5600000\n"
                              "JSET, 1, 30, 0, 5, , 10, , 5\nJSET, 2, 120, 0, 10, 1\n"
                              "JSET, 3, 0, 0, 100\nCUT\nCYCLE, 1\n");
  const std::string said = ": the set starts at the first corner of the outline, "
                           "(350000, 5600000), because (0, 0) is far away";
  const auto times_in = [&](const std::string& text) {
    int times = 0;
    for (auto at = text.find(said); at != std::string::npos; ++times)
      at = text.find(said, at + 1);
    return times;
  };
  const Outcome check = blocks("check a.deck", folder_.path());
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_EQ(times_in(check.err), 3) << check.err;
  const Outcome run = blocks("run a.deck", folder_.path());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(times_in(run.err), 3) << run.err;
  EXPECT_EQ(times_in(slurp(folder_ / "a.out")), 3);
}

// A joint that deviates turns about the point nearest to the start. From far away, the
// joints of a set have lost their order.
TEST_F(CutCards, JointsThatDeviateBeginAtAnOutlineTenSizesAway) {
  const auto said = [&](double x, const std::string& ddev) {
    std::string cards = start();
    cards.replace(cards.find("XLIMITS"), cards.find("BOXES") - cards.find("XLIMITS"),
                  "XLIMITS, -1000, 1000\nYLIMITS, -1000, 1000\n");
    folder_.write("a.deck", cards + fmt::format("OUTLINE, 4, 1\n{0}, {0}, {1}, {1}\n"
                                                "0, 10, 10, 0\nJSET, 1, 30, {2}, 1\n"
                                                "CUT\nCYCLE, 1\n",
                                                x, x + 10, ddev));
    return blocks("check a.deck", folder_.path()).err;
  };
  EXPECT_THAT(said(200, "5"), HasSubstr("because (0, 0) is far away"));
  EXPECT_THAT(said(100, "5"), Not(HasSubstr("JSET")));
  EXPECT_THAT(said(200, ""), Not(HasSubstr("JSET")));
}

TEST_F(CutCards, LongWorkShowsProgressAndEndsAtAnInterrupt) {
  std::string cards = start();
  cards.replace(0, cards.find('\n'), "START, 2000000, 500");
  folder_.write("a.deck", cards + "OUTLINE, 4, 1\n-9, -9, 9, 9\n-9, 9, 9, -9\n"
                                  "JSET, 1, , , .02\nJSET, 2, 40, , .02\nCUT\n");
  const Outcome stopped = blocks(
      "--version && timeout --foreground --preserve-status -s INT 3.5 '" BLOCKS_PROGRAM
      "' check a.deck",
      folder_.path());
  EXPECT_EQ(stopped.code, 130);
  EXPECT_THAT(stopped.err, HasSubstr("CUT in line "));
  EXPECT_THAT(stopped.err, HasSubstr(" %, "));
  EXPECT_THAT(stopped.err, HasSubstr("blocks: interrupted; no file was written\n"));
  EXPECT_FALSE(folder_.holds("a.out"));
}

TEST_F(CutCards, TracesAreReadCutAndComparedByARestart) {
  folder_.write("traces.csv", "x1,y1,x2,y2,joint\n-5,0,4,0,3\n0,-5,0,5,\n");
  const std::string deck = start() + square("TRACES, traces.csv, 2, 1") + "CYCLE, 20\n";
  folder_.write("a.deck", deck);
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_THAT(told.out,
              AllOf(HasSubstr("4 blocks (0 fixed), 16 corners, area 100\n"),
                    HasSubstr("TRACES: traces.csv: CSV, 2 polylines, 2 "
                              "segments\n"),
                    HasSubstr("TRACES: traces.csv: 1 loose end prolonged, by 1 "
                              "at most\n")));
  EXPECT_EQ(blocks("check a.deck --set TRACES.snap=.9", folder_.path())
                .out.find("3 blocks (0 fixed)"),
            told.out.find("4 blocks (0 fixed)"));
  ASSERT_EQ(blocks("run a.deck -q --stop-after 10", folder_.path()).code, 75);
  folder_.write("traces.csv", "-5,1,4,1\n0,-5,0,5\n");
  const Outcome again = blocks("run a.deck -q --restart a.ckpt.h5", folder_.path());
  EXPECT_EQ(again.code, 5);
  EXPECT_THAT(again.err,
              HasSubstr("a file that READ9, OUTLINE, TRACES or VORONOI reads has "
                        "changed"));
}

TEST_F(CutCards, FaultyTracesAreReportedWithTheirPlaces) {
  folder_.write("traces.csv", "1,2,3,4\n1,2,x,4\n1,2\n");
  folder_.write("a.deck", start() + square("TRACES, traces.csv, 2, 1"));
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_EQ(told.code, 3);
  EXPECT_THAT(told.err, AllOf(HasSubstr("a.deck:15:9: error: TRACES: traces.csv:2:5: "),
                              HasSubstr("TRACES: traces.csv:3:1: ")));
}

TEST_F(CutCards, TooManyBlocksAreRefusedBeforeTheyAreCut) {
  folder_.write("a.deck",
                start() + square("JSET, 1, 0, 0, .001\nJSET, 2, 90, 0, .001"));
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_EQ(told.code, 3);
  EXPECT_THAT(told.err, AllOf(HasSubstr("error: OUTLINE: about 1e+08 crossings"),
                              HasSubstr("START allows 50000 more blocks")));
}

TEST_F(CutCards, WarningsOfATraceFileStayWarnings) {
  std::string features;
  for (int i = 0; i < 8; ++i)
    features += R"({"type": "Feature", "properties": {}, "geometry": null}, )";
  folder_.write("a.geojson", R"({"type": "FeatureCollection", "features": [)" +
                                 features +
                                 R"({"type": "Feature", "properties": {}, "geometry": )"
                                 R"({"type": "LineString", "coordinates": [[-9, 0], )"
                                 R"([9, 1]]}}]})");
  folder_.write("a.deck", start() + square("TRACES, a.geojson"));
  const Outcome told = blocks("check a.deck", folder_.path());
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("a.geojson: 3 more like these"));
}

TEST_F(CutCards, SeedsOfASweepChangeTheJoints) {
  folder_.write("a.deck", start() + square("VORONOI, 9") + "CYCLE, 1\n");
  const Outcome sweep = blocks("sweep a.deck --seeds 1-2 --check -o s", folder_.path());
  EXPECT_EQ(sweep.code, 0) << sweep.err;
  EXPECT_THAT(sweep.err, Not(HasSubstr("all seeds give the same")));
}

TEST_F(CutCards, CanBeStudied) {
  folder_.write("a.deck", start() + square("JSET, 1, 30, 8, 4, 1\nVORONOI, 5") +
                              "GRAVITY, 0, -9.81\nCYCLE, 20\n");
  const Outcome study = blocks(
      "study contacts a.deck --frames 2 --steps 20 --variants default", folder_.path());
  EXPECT_EQ(study.code, 0) << study.err;
}

}  // namespace
}  // namespace blocks::testing
