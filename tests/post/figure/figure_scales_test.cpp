// The scales of figures: ranges of colours and lengths of arrows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <utility>

#include "post/figure/figure.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/figure/two_squares.hpp"
#include "post/read/frame_quantity.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using ::testing::HasSubstr;

// Stresses from 0 to 8 had a bar from -8 to 8, half of it without a value.
TEST(Figure, ValuesOfOneSignHaveHalfOfADivergingMap) {
  Frame frame = two_squares();
  FigureOptions options;
  options.colour = "VELX";
  const auto scales = [&](double first, double second) {
    frame.velocity.row(0) << first, second;
    ScaleSurvey survey(options);
    const FrameContacts none;
    survey.include({frame, frame, none});
    return survey.scales();
  };
  const auto colour = [&](const ValueRange& range, double value) {
    const Colour at = map_of(options, Zero::middle, range).at(range.place(value));
    return std::array{at.r, at.g, at.b};
  };
  const auto all = [](const Colour& c) { return std::array{c.r, c.g, c.b}; };
  const ValueRange above = scales(3, 8).colours, below = scales(-8, -3).colours,
                   both = scales(-3, 8).colours;
  EXPECT_EQ(above.low, 0.0);
  EXPECT_EQ(above.high, 8.0);
  EXPECT_EQ(below.low, -8.0);
  EXPECT_EQ(below.high, 0.0);
  EXPECT_EQ(both.low, -8.0);
  EXPECT_EQ(both.high, 8.0);
  for (const ValueRange& range : {above, below, both})
    EXPECT_EQ(colour(range, 0), all(diverging(0.5)));
  // A small side does not need the other half of the map either (-15409 to 165).
  const ValueRange nearly = scales(-8, 0.7).colours, enough = scales(-8, 0.9).colours;
  EXPECT_EQ(std::pair(nearly.low, nearly.high), std::pair(-8.0, 0.7));
  EXPECT_EQ(std::pair(enough.low, enough.high), std::pair(-8.0, 8.0));
  const auto near = [](const std::array<double, 3>& one, const Colour& other) {
    EXPECT_NEAR(one[0], other.r, 1e-12);
    EXPECT_NEAR(one[1], other.g, 1e-12);
    EXPECT_NEAR(one[2], other.b, 1e-12);
  };
  near(colour(nearly, -8), diverging(0));
  near(colour(nearly, 0), diverging(0.5));
  near(colour(nearly, 0.7), diverging(0.5 + 0.5 * 0.7 / 8));
  near(colour({-2, 4}, 0), diverging(0.5));  // also in a range that the user gives
  EXPECT_EQ(colour(above, 8), all(diverging(1)));
  EXPECT_EQ(colour(below, -8), all(diverging(0)));
}

TEST(Figure, AQuantityThatIsZeroEverywhereHasNoBar) {
  const Folder folder;
  const std::string path = folder.file("zero.svg");
  Frame frame = two_squares();
  frame.velocity.setZero();
  for (const char* name : {"VELX", "speed"}) {
    FigureOptions options;
    options.colour = name;
    draw_frame(path, frame, frame, "at rest", options);
    EXPECT_NE(content(path).find(">0 everywhere<"), std::string::npos) << name;
    options.range = Eigen::Vector2d(0, 4);
    draw_frame(path, frame, frame, "at rest", options);
    EXPECT_EQ(content(path).find(">0 everywhere<"), std::string::npos) << name;
  }
}

// The arrow of one loose block must not hide those of all others.
TEST(Figure, TakesAScaleOfArrowsFromTheOptions) {
  Frame frame = two_squares();
  FigureOptions options;
  options.arrows = "velocity";
  frame.fixed = {0, 0};
  frame.velocity << 0.01, 5, 0, 0;
  const auto scales = [&](std::optional<ArrowScale> scale) {
    options.arrow_scale = scale;
    ScaleSurvey survey(options);
    const FrameContacts none;
    survey.include({frame, frame, none});
    return survey.scales();
  };
  EXPECT_EQ(scales({}).arrow, 5.0);
  EXPECT_FALSE(scales({}).cuts_arrows);
  EXPECT_EQ(scales(ArrowScale{6.0}).arrow, 6.0);
  EXPECT_FALSE(scales(ArrowScale{6.0}).cuts_arrows);
  EXPECT_EQ(scales(ArrowScale{0.0, 0.0}).arrow, 0.01);
  EXPECT_EQ(scales(ArrowScale{0.02}).arrow, 0.02);
  EXPECT_TRUE(scales(ArrowScale{0.02}).cuts_arrows);
  const Folder folder;
  draw_frame(folder.file("a.svg"), frame, frame, "two squares", options);
  EXPECT_THAT(content(folder.file("a.svg")), HasSubstr("≥ 0.02 "));
}

TEST(Figure, SaysWhichEndsOfTheRangeCutValues) {
  Frame frame = two_squares();
  FigureOptions options;
  options.colour = "VELX";
  frame.velocity.row(0) << 3, 8;
  const auto cuts = [&](double low, double high) {
    options.range = Eigen::Vector2d(low, high);
    ScaleSurvey survey(options);
    const FrameContacts none;
    survey.include({frame, frame, none});
    const FigureScales scales = survey.scales();
    return std::pair{scales.cuts_low, scales.cuts_high};
  };
  EXPECT_EQ(cuts(3, 8), std::pair(false, false));
  EXPECT_EQ(cuts(4, 8), std::pair(true, false));
  EXPECT_EQ(cuts(0, 7), std::pair(false, true));
}

// A block that has not moved is not the darkest one.
TEST(ColourMap, IsLightAtZeroIfZeroIsOrdinary) {
  Frame frame;
  frame.number = {1}, frame.fixed = {0};
  frame.centroid = frame.velocity = Eigen::Matrix2Xd::Zero(2, 1);
  frame.mass = frame.inertia = frame.area = Eigen::VectorXd::Ones(1);
  frame.spin = Eigen::VectorXd::Zero(1);
  const auto map = [&](const char* name) {
    return usual_colour_map(quantity(name, frame, frame).zero);
  };
  for (const char* name : {"speed", "displacement", "kinetic_energy", "overlap"})
    EXPECT_GT(luminance(colour_map(map(name)).at(0)), 0.9) << name;
  EXPECT_EQ(map("vx"), "bluered");
  EXPECT_EQ(map("x"), "viridis");
  EXPECT_EQ(map("mass"), "viridis");
}

}  // namespace
}  // namespace blocks::post
