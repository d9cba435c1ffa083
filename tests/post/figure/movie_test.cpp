// Figures of several times, movies, and the network of contact forces.
#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "post/read/force_network.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// The deck of a square on a fixed floor, and another one that moves towards it.
const std::string scene = preliminary() + "FRICTN, 0.8\n" +
                          rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
                          rectangle(1.02, 0.3, 2.02, 1.3) +
                          "SETVEL, 3, 0, -2, -2\nPLOTS, 0.004\nCYCLE, 100\n";

class PlotCommand : public ::testing::Test {
 protected:
  void SetUp() override { run_text(folder_, "hit", scene); }
  Outcome plot(const std::string& arguments) const {
    return blocks("plot hit.vtkhdf " + arguments, folder_.path());
  }
  std::pair<int, int> size(const std::string& name) const {
    cairo_surface_t* image =
        cairo_image_surface_create_from_png((folder_ / name).c_str());
    const std::pair<int, int> found = {cairo_image_surface_get_width(image),
                                       cairo_image_surface_get_height(image)};
    cairo_surface_destroy(image);
    return found;
  }
  /// Puts a script in place of ffmpeg for this test.
  void with_ffmpeg(const std::string& script) {
    std::filesystem::create_directory(folder_ / "bin");
    folder_.write("bin/ffmpeg", script);
    std::filesystem::permissions(folder_ / "bin/ffmpeg",
                                 std::filesystem::perms::owner_all);
    setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  void TearDown() override { setenv("PATH", path_.c_str(), 1); }

  TemporaryFolder folder_;
  const std::string path_ = std::getenv("PATH");
};

// Without gravity the links to a free block add up to the stored force on it. The edges
// of a frame are one step later than its forces, so they have turned by the spin of a
// step.
TEST_F(PlotCommand, HasTheForcesThatMoveTheBlocks) {
  const post::ResultsReader results((folder_ / "hit.vtkhdf").string());
  double max = 0.0, shear = 0.0;
  for (long i = 0; i < results.frames(); ++i) {
    const post::Frame now = results.frame(i);
    const post::FrameContacts contacts = results.contacts(i);
    if (contacts.size() > 0)
      shear = std::max(shear, contacts.shear_force.cwiseAbs().maxCoeff());
    Eigen::Matrix2Xd sum = Eigen::Matrix2Xd::Zero(2, now.size());
    for (const post::ForceLink& link : post::force_network(contacts)) {
      sum.col(link.first) -= link.force;
      sum.col(link.second) += link.force;
      max = std::max(max, link.force.norm());
    }
    for (int b = 0; b < now.size(); ++b)
      if (now.fixed[static_cast<std::size_t>(b)] == 0) {
        EXPECT_LE((sum.col(b) - now.force.col(b)).norm(), 2e-3 * max);
      }
  }
  EXPECT_GT(shear, 0.1 * max) << "nothing slid";
}

// Two pictures side by side are half as wide, so the sheet has less height.
TEST_F(PlotCommand, PutsSeveralTimesOnASheet) {
  ASSERT_EQ(plot("-t 0,0.02 --columns 2 -o two.png").code, 0);
  ASSERT_EQ(plot("-t 0 -o one.png").code, 0);
  EXPECT_EQ(size("two.png").first, 1200);
  EXPECT_LT(size("two.png").second, size("one.png").second);
}

TEST_F(PlotCommand, DrawsInPrintWithLegendsBesideOrBelow) {
  const std::string all = "--sheet 2 --forces --arrows velocity --colour speed ";
  ASSERT_EQ(plot(all + "--size single -o single.png").code, 0);
  ASSERT_EQ(plot(all + "--size double -o double.png").code, 0);
  EXPECT_EQ(size("single.png").first, 1004);
  EXPECT_EQ(size("double.png").first, 2067);
  const Outcome curves =
      blocks("history hit.vtkhdf --size 85mmx90mm -o curves.png", folder_.path());
  ASSERT_EQ(curves.code, 0) << curves.err;
  EXPECT_EQ(size("curves.png"), std::pair(1004, 1063));
}

TEST_F(PlotCommand, DrawsASheetWithAllDecorations) {
  const Outcome all = plot("--sheet 3 --forces --arrows velocity --corners --numbers "
                           "--colour overlap --range 0,1 --units m,kg,s -o three.svg");
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(slurp(folder_ / "three.svg"), HasSubstr("<svg"));
}

// A pixel has four bytes, and no two pictures are equal.
TEST_F(PlotCommand, SendsEveryPictureOfAMovieToFfmpeg) {
  with_ffmpeg("#!/bin/sh\nfor last; do :; done\necho \"$@\" > words\n"
              "cat > ${last#file:}\n");
  const Outcome movie = plot("--width 200 --every 2 --rate 5 -o hit.mp4");
  ASSERT_EQ(movie.code, 0) << movie.err;
  EXPECT_THAT(movie.out, HasSubstr("hit.mp4: 6 pictures, 1.2 s"));
  const std::string words = slurp(folder_ / "words"),
                    bytes = slurp(folder_ / "hit.mp4");
  const auto at = words.find("-video_size ") + 12;
  const int width = std::stoi(words.substr(at)),
            height = std::stoi(words.substr(words.find('x', at) + 1));
  EXPECT_EQ(width, 200);
  const auto picture = static_cast<std::size_t>(4 * width * height);
  ASSERT_EQ(bytes.size(), 6 * picture);
  for (std::size_t k = 1; k < 6; ++k)
    EXPECT_NE(bytes.substr(0, picture), bytes.substr(k * picture, picture)) << k;
  EXPECT_THAT(words, HasSubstr("-framerate 5 "));
}

TEST_F(PlotCommand, KeepsAnOlderMovie) {
  with_ffmpeg("#!/bin/sh\nfor last; do :; done\ncat > ${last#file:}\n");
  ASSERT_EQ(plot("--width 200 --every 2 --rate 5 -o hit.mp4").code, 0);
  ASSERT_EQ(plot("--width 200 -o hit.mp4").code, 0);
  EXPECT_TRUE(folder_.holds("hit.mp4.bak"));
}

TEST_F(PlotCommand, SaysThatFfmpegFailed) {
  with_ffmpeg("#!/bin/sh\nexit 3\n");
  const Outcome failed = plot("-o hit.gif");
  EXPECT_EQ(failed.code, 5);
  EXPECT_THAT(failed.err, HasSubstr("cannot write hit.gif: ffmpeg failed"));
  EXPECT_FALSE(folder_.holds("hit.gif"));
}

TEST_F(PlotCommand, SaysThatFfmpegIsMissing) {
  setenv("PATH", folder_.path().c_str(), 1);
  const Outcome missing = plot("-o hit.gif");
  EXPECT_EQ(missing.code, 5);
  EXPECT_THAT(missing.err,
              HasSubstr("needs the program ffmpeg, which is not installed"));
}

TEST_F(PlotCommand, NamesTheChoicesIfAnOptionIsWrong) {
  const auto expect_refusal = [&](const std::string& arguments,
                                  const std::string& words) {
    const Outcome run = plot(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_THAT(run.err, HasSubstr(words)) << arguments;
  };
  expect_refusal("-o hit.bmp", ".mp4 or .gif (a movie), found 'hit.bmp'");
  expect_refusal("--colour heat",
                 "choose material, family, joint, bond, opening, shear_displacement, "
                 "water_pressure, speed, displacement, rotation");
  expect_refusal("--colour heat", "normal_force, overlap, shear_force");
  expect_refusal("--sheet 3 --from 7", "has times 0 to 0.04, none between 7 and 0.04");
  expect_refusal("--zoom 1,0,0,1", "xmin < xmax");
  expect_refusal("--zoom 8,9,8,9",
                 "no block in the zoom: the blocks lie in x -5 to 5, y -1 to ");
  expect_refusal("--colour speed --colormap jet", "viridis, cividis, grey");
  expect_refusal("--size 85", "--size needs a width such as 85mm");
  for (const char* scale : {"0", "-1", "p101", "max", "1m", "inf", "nan"})
    expect_refusal(std::string("--arrows velocity --arrow-scale=") + scale,
                   "--arrow-scale needs a value above 0, or a percentile such as p90");
  expect_refusal("--size 85mm -o hit.mp4", "--width");
  expect_refusal("--colour speed --range 1,1", "low < high");
  expect_refusal("--materials 7=RED",
                 "there is no material 7 in hit.vtkhdf\n  hint: materials: 1\n");
  expect_refusal("--materials 1=REED", "BLUE, CLEARC, CYAN, GREEN");
}

TEST_F(PlotCommand, RefusesOptionsWithoutEffect) {
  for (const char* options :
       {"--rate 10", "--every 2", "--columns 3", "--range 0,1", "--colormap grey",
        "--from 0", "--mirror nan", "--colour speed --materials 1=RED",
        "--compression-positive", "--arrow-scale 1", "--sheet 3 -o hit.mp4"}) {
    const Outcome run = plot(options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr("blocks: error: --")) << options;
  }
}

// The block at rest has the first colour of the map.
TEST_F(PlotCommand, PaintsAQuantityWithTheChosenColourMap) {
  EXPECT_EQ(plot("--colour speed --colormap cividis -o c.svg").code, 0);
  const std::regex first("rgb\\(0%, ?13\\.3");
  EXPECT_TRUE(std::regex_search(slurp(folder_ / "c.svg"), first));
}

TEST_F(PlotCommand, RefusesTheStressOfRigidBlocks) {
  const Outcome stress = plot("--colour s22");
  EXPECT_EQ(stress.code, 2);
  EXPECT_THAT(stress.err, HasSubstr("RIGID blocks have no stress"));
}

// The block of strained.deck has a stress.
TEST(CompressionPositive, ChangesTheSignOfStressesAndTheLegend) {
  const TemporaryFolder folder;
  run_text(
      folder, "strained",
      slurp(std::filesystem::path(BLOCKS_SOURCE_DIR) / "tests/post/strained.deck"));
  post::ResultsReader results((folder / "strained.vtkhdf").string());
  const post::Frame tension = results.frame(results.frames() - 1);
  results.make_compression_positive();
  const post::Frame compression = results.frame(results.frames() - 1);
  EXPECT_GT(tension.stress.norm(), 0.0);
  EXPECT_EQ(compression.stress, -tension.stress);
  const Outcome plot = blocks(
      "plot strained.vtkhdf --colour p1 --compression-positive --size double -o p.svg",
      folder.path());
  ASSERT_EQ(plot.code, 0) << plot.err;
  EXPECT_THAT(slurp(folder / "p.svg"), HasSubstr("compression"));
}

// The deck stores a frame every 0.004.
TEST_F(PlotCommand, SaysIfTheNearestFrameIsNotAtTheTimeAskedFor) {
  ASSERT_EQ(plot("-t 0.008,0.0095 -o times.svg").code, 0);
  const std::string svg = slurp(folder_ / "times.svg");
  EXPECT_THAT(svg, HasSubstr(">t = 0.008</text>"));
  EXPECT_THAT(svg, HasSubstr(">t = 0.008, nearest to 0.0095</text>"));
}

// Without the title the page is lower.
TEST_F(PlotCommand, LeavesOutAnEmptyTitle) {
  ASSERT_EQ(plot("-o titled.png").code, 0);
  const Outcome bare = plot("--title '' -o bare.png");
  ASSERT_EQ(bare.code, 0) << bare.err;
  EXPECT_LT(size("bare.png").second, size("titled.png").second);
}

TEST_F(PlotCommand, WritesPathsInAFigureOfCurvesOnlyIfAsked) {
  const auto height = [&](const std::string& options, const std::string& name) {
    EXPECT_EQ(
        blocks("history hit.vtkhdf " + options + " -o " + name, folder_.path()).code,
        0);
    return size(name).second;
  };
  const int usual = height("", "usual.png");
  EXPECT_LT(usual, height("--paths", "paths.png"));
  EXPECT_GT(usual, height("--title ''", "bare.png"));
}

TEST_F(PlotCommand, PaintsAMaterialInTheChosenColour) {
  EXPECT_EQ(plot("--materials 1=zuni --colour MATERIAL -o painted.svg").code, 0);
  const std::regex zuni("rgb\\(45%, ?70%, ?92%\\)");
  EXPECT_TRUE(std::regex_search(slurp(folder_ / "painted.svg"), zuni));
}

}  // namespace
}  // namespace blocks::testing
