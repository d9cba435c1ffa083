// `blocks cracks`, and the number of cracks in histories. A block of 1 x 1 m is pulled
// by pressures on its left and right sides, so that all cracks are vertical.
#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "draw/joint_colours.hpp"
#include "post/chart/cracks_figure.hpp"
#include "post/chart/history.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Returns a deck whose block is pulled by 1.2 MPa. Each piece that is still pulled on
/// its outer side reaches 1.2 MPa again, so it splits until pieces would be too small.
std::string pulled(const std::string& cards = "CRACK, 1, 1.E6, 0.1\n") {
  return preliminary("UNITS, m, kg, s\nFUNCTION, 1\n0., 1.\n") + rectangle(0, 0, 1, 1) +
         "PRESSBC, 1, 1, -1.2E6, -1.2E6\nPRESSBC, 1, 3, -1.2E6, -1.2E6\n" + cards +
         "PLOTS, 0.0002\nMOTION, 0.004\n";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    found.push_back(line);
  return found;
}

TEST(CracksCommand, PrintsATableOfTheCracks) {
  const TemporaryFolder folder;
  run_text(folder, "pulled", pulled());
  const Outcome table = blocks("cracks pulled.vtkhdf", folder.path());
  ASSERT_EQ(table.code, 0) << table.err;
  const auto lines = lines_of(table.out);
  ASSERT_EQ(lines.size(), 8U) << table.out;
  EXPECT_EQ(lines[0], "A SMALL PROBLEM (pulled.vtkhdf)");
  EXPECT_THAT(lines[1],
              StartsWith("3 cracks (3 by stress, 0 by point loads), energy released "));
  EXPECT_THAT(lines[3], HasSubstr("parent  child   cause"));
  EXPECT_THAT(lines[4], AllOf(HasSubstr("Pa"), HasSubstr("degrees")));
  // The halves split in the same step, in the order of their numbers.
  EXPECT_THAT(lines[5], HasSubstr(" 1      2  stress"));
  EXPECT_THAT(lines[6], HasSubstr(" 1      3  stress"));
  EXPECT_THAT(lines[7], HasSubstr(" 2      4  stress"));
  EXPECT_THAT(std::vector(lines.begin() + 5, lines.end()), Each(HasSubstr(" 90 ")));
}

TEST(CracksCommand, WritesAllValuesAndTheChosenTimes) {
  const TemporaryFolder folder;
  run_text(folder, "pulled", pulled());
  const auto cracks = post::ResultsReader((folder / "pulled.vtkhdf").string()).cracks();
  ASSERT_EQ(cracks.size(), 3U);
  const Outcome csv = blocks("cracks pulled.vtkhdf --csv", folder.path());
  ASSERT_EQ(lines_of(csv.out).size(), 4U);
  EXPECT_EQ(lines_of(csv.out)[0],
            "step,time,parent,child,cause,stress,angle,length,from_x,from_y,to_x,to_y,"
            "moved,parent_area,child_area,kinetic_before,kinetic_after,strain_before,"
            "strain_after,released");
  const Outcome early =
      blocks("cracks pulled.vtkhdf --json --to 0.8 --units mm,kg,ms", folder.path());
  ASSERT_EQ(early.code, 0) << early.err;
  const auto columns = nlohmann::json::parse(early.out)["runs"][0]["columns"];
  EXPECT_EQ(columns[1]["values"], nlohmann::json({1e3 * cracks[0].time}));
  EXPECT_EQ(columns[4]["values"], nlohmann::json({"stress"}));
  EXPECT_EQ(columns[7]["unit"], "mm");
  EXPECT_EQ(columns[7]["values"], nlohmann::json({1e3 * cracks[0].length()}));
  const Outcome files =
      blocks("cracks pulled.vtkhdf -o a.csv,a.json,a.svg,a.pdf", folder.path());
  ASSERT_EQ(files.code, 0) << files.err;
  EXPECT_EQ(slurp(folder / "a.csv"), csv.out);
  EXPECT_THAT(slurp(folder / "a.svg"),
              AllOf(HasSubstr("cracks by stress"), HasSubstr("3 cracks")));
}

TEST(CracksCommand, OfADeckWithoutCracksListsNone) {
  const TemporaryFolder folder;
  run_text(folder, "whole", pulled(""));
  EXPECT_EQ(blocks("cracks whole.vtkhdf", folder.path()).out,
            "A SMALL PROBLEM (whole.vtkhdf)\nno cracks\n");
  EXPECT_EQ(lines_of(blocks("cracks whole.vtkhdf --csv", folder.path()).out).size(),
            1U);
  const Outcome figure = blocks("cracks whole.vtkhdf -o a.png", folder.path());
  EXPECT_EQ(figure.code, 2);
  EXPECT_THAT(figure.err, HasSubstr("whole.vtkhdf has no cracks to draw\n  hint: "));
  EXPECT_FALSE(folder.holds("a.png"));
  EXPECT_EQ(blocks("cracks whole.vtkhdf -o whole.vtkhdf", folder.path()).code, 2);
}

// The HISTORY card counts at its samples, otherwise frames count.
TEST(CracksHistory, IsTheNumberOfCracksSoFar) {
  const TemporaryFolder folder;
  run_text(folder, "pulled", pulled("HISTORY, 0.0001, cracks\nCRACK, 1, 1.E6, 0.1\n"));
  const post::ResultsReader results((folder / "pulled.vtkhdf").string());
  const auto cracks = results.cracks();
  const std::vector<post::Curve> curve = {quantities::parse_curve("cracks")};
  for (const bool frames : {false, true}) {
    const post::History history = post::read_history({&results}, curve, {}, frames);
    ASSERT_GE(history.series[0].values.size(), frames ? 20U : 41U);
    for (std::size_t i = 0; i < history.time.size(); ++i) {
      const double t = history.time[i], dt = 8e-5;  // at least a step
      const auto until = [&](double time) {
        return static_cast<double>(
            std::count_if(cracks.begin(), cracks.end(),
                          [&](const auto& crack) { return crack.time <= time; }));
      };
      EXPECT_GE(history.series[0].values[i], until(t - dt)) << t;
      EXPECT_LE(history.series[0].values[i], until(t + dt)) << t;
    }
    EXPECT_EQ(history.series[0].values.back(), 3.0);
  }
  EXPECT_EQ(blocks("history pulled.vtkhdf -q cracks,blocks", folder.path()).code, 0);
}

TEST(CracksHistory, IsZeroForResultsWithoutTheRecord) {
  const TemporaryFolder folder;
  run_text(folder, "whole", pulled(""));
  const post::ResultsReader results((folder / "whole.vtkhdf").string());
  const post::History history =
      post::read_history({&results}, {quantities::parse_curve("cracks")});
  EXPECT_THAT(history.series[0].values, Each(0.0));
}

/// Returns the red, green and blue of a pixel of a PNG.
draw::Colour pixel_at(const std::string& path, double x, double y) {
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  EXPECT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  const unsigned char* at =
      cairo_image_surface_get_data(image) +
      static_cast<int>(y) * cairo_image_surface_get_stride(image) +
      4 * static_cast<int>(x);
  const draw::Colour found{at[2] / 255.0, at[1] / 255.0, at[0] / 255.0};
  cairo_surface_destroy(image);
  return found;
}

// A crack of length 3 at 90 degrees by stress and one of length 1 at 0 degrees by point
// loads: the sector upwards is three times as large, so its radius is sqrt(3) times as
// large.
TEST(CracksFigure, RoseIsWeightedByLength) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.png").string();
  post::Crack up, along;
  up.from = {1, 1}, up.to = {1, 4};
  along.from = {5, 2}, along.to = {4, 2};
  along.by_points = true;
  up.child_area = along.child_area = 0.5;
  post::draw_cracks_figure(path, {up, along}, "two cracks", {});
  const double x = 420, base = 380, radius = 262;  // of the half disc on the page
  const auto expect_colour = [&](double at_x, double at_y, const draw::Colour& colour) {
    const draw::Colour found = pixel_at(path, at_x, at_y);
    EXPECT_NEAR(found.r, colour.r, 0.02);
    EXPECT_NEAR(found.g, colour.g, 0.02);
    EXPECT_NEAR(found.b, colour.b, 0.02);
  };
  expect_colour(x + 1, base - 0.95 * radius, draw::joint_colour(1));
  expect_colour(x + 0.55 * radius, base - 3, draw::joint_colour(2));
  expect_colour(x - 0.55 * radius, base - 3, draw::joint_colour(2));
  const draw::Colour disc{0.965, 0.965, 0.968};
  expect_colour(x + 0.61 * radius, base - 3, disc);
  expect_colour(x + 0.4 * radius, base - 0.4 * radius, disc);
}

}  // namespace
}  // namespace blocks::testing
