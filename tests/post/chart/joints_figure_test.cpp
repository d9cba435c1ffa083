// Figures of joints: sides in the colours of their joints, the rose and the histograms.
#include "post/chart/joints_figure.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "draw/axes.hpp"
#include "draw/joint_colours.hpp"
#include "post/chart/joint_statistics.hpp"
#include "tools/program.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The red, green and blue of a pixel of a PNG.
Colour pixel_of(const std::string& path, double x, double y) {
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  EXPECT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  const unsigned char* at =
      cairo_image_surface_get_data(image) +
      static_cast<int>(y) * cairo_image_surface_get_stride(image) +
      4 * static_cast<int>(x);
  const Colour found{at[2] / 255.0, at[1] / 255.0, at[0] / 255.0};
  cairo_surface_destroy(image);
  return found;
}

void expect_colour(const Colour& found, const Colour& expected) {
  EXPECT_NEAR(found.r, expected.r, 0.02);
  EXPECT_NEAR(found.g, expected.g, 0.02);
  EXPECT_NEAR(found.b, expected.b, 0.02);
}

/// Two unit squares side by side and a triangle without joints. Joint 1 is between the
/// squares, joint 2 is below both.
Frame two_squares_with_joints() {
  Frame frame;
  frame.outlines = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}},
                    {{1, 0}, {1, 1}, {2, 1}, {2, 0}},
                    {{0, 1.5}, {0, 2}, {2, 2}}};
  frame.joints = {{0, 0, 1, 2}, {1, 0, 0, 2}, {0, 0, 0}};
  frame.number = {1, 2, 3};
  frame.material = {1, 1, 1};
  frame.fixed = {0, 0, 0};
  frame.centroid = (Eigen::Matrix2Xd(2, 3) << 0.5, 1.5, 0.7, 0.5, 0.5, 1.8).finished();
  frame.area = Eigen::Vector3d(1, 1, 0.5);
  return frame;
}

TEST(JointsInFigure, SidesHaveTheColourOfTheirJoint) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder / "a.png").string();
  FigureOptions options;
  options.colour = "joint";
  options.zoom = Eigen::Vector4d(0, 2, -0.5, 1.5);
  const Frame frame = two_squares_with_joints();
  draw_frame(path, frame, frame, "joints", options);
  const Axes axes({0, 2, -0.5, 1.5}, 84, 78, 966);  // the place of a single picture
  expect_colour(pixel_of(path, axes.x(1), axes.y(0.5)), joint_colour(1));
  expect_colour(pixel_of(path, axes.x(0.5), axes.y(0)), joint_colour(2));
  expect_colour(pixel_of(path, axes.x(1.5), axes.y(0)), joint_colour(2));
  // The other sides are thin, and the blocks are paler than their material.
  const Colour fill = mix(material_colour(1), Colour{1, 1, 1}, 0.3);
  expect_colour(pixel_of(path, axes.x(0.5), axes.y(1) + 2), fill);
}

TEST(JointsInFigure, AFrameWithoutJointIdsIsRefusedWithAHint) {
  const testing::TemporaryFolder folder;
  FigureOptions options;
  options.colour = "joint";
  Frame frame = two_squares_with_joints();
  frame.joints.clear();
  const auto expect_refusal = [&](const auto& draw) {
    try {
      draw();
      ADD_FAILURE() << "it was drawn";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("no side of a block has a joint id"));
      EXPECT_THAT(error.what(), HasSubstr("\n  hint: "));
    }
  };
  const std::string path = (folder / "a.png").string();
  expect_refusal([&] { draw_frame(path, frame, frame, "", options); });
  expect_refusal([&] { draw_joints_figure(path, frame, "", options); });
  EXPECT_FALSE(folder.holds("a.png"));
}

TEST(JointsInFigure, StatisticsAreThoseOfTheSides) {
  const JointStatistics joints = joint_statistics(two_squares_with_joints());
  ASSERT_EQ(joints.directions.groups.size(), 2U);
  // Each of the two squares has one side of each joint, all of length 1.
  EXPECT_NEAR(joints.directions.groups.at(1).share, 0.5, 1e-12);
  EXPECT_NEAR(joints.directions.groups.at(1).mean, 90.0, 1e-9);
  EXPECT_NEAR(joints.directions.groups.at(1).deviation.value(), 0.0, 1e-5);
  EXPECT_NEAR(joints.directions.groups.at(1).sectors.at(9), 0.5, 1e-12);
  EXPECT_NEAR(joints.directions.groups.at(2).sectors.at(0), 0.5, 1e-12);
  EXPECT_THAT(joints.area, ElementsAre(1.0, 1.0));  // without the triangle
  EXPECT_THAT(joints.sides, ElementsAre(4.0, 4.0));
  EXPECT_NEAR(joints.aspect.at(0), 1.0, 1e-9);
}

// A logarithmic axis has no place for an area of 0.
TEST(JointsInFigure, BlocksWithoutAreaAreLeftOut) {
  Frame frame = two_squares_with_joints();
  frame.outlines[1] = {{1, 0}, {1, 1}, {1, 1}, {1, 0}};
  EXPECT_THAT(joint_statistics(frame).area, ElementsAre(1.0));
  frame.outlines[0] = frame.outlines[1];
  EXPECT_THROW(joint_statistics(frame), std::runtime_error);
}

/// Returns a frame with one triangle that has a side of this joint in each direction.
Frame fan(const std::vector<double>& degrees, const std::vector<double>& lengths) {
  Frame frame;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double angle = degrees[i] * std::acos(-1.0) / 180.0;
    const Eigen::Vector2d side = lengths[i] *
                                 Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                          left(-side.y(), side.x());
    frame.outlines.push_back({{0, 0}, 0.5 * side + left, side});
    frame.joints.push_back({0, 0, 3});
  }
  return frame;
}

// Directions are axes: 179 and 1 degrees are 2 degrees apart, and their mean is 0.
TEST(JointsInFigure, DirectionsAreAxesWeightedByLength) {
  const JointStatistics near_x = joint_statistics(fan({179, 1}, {1, 1}));
  const double mean = near_x.directions.groups.at(3).mean;
  EXPECT_LT(std::min(mean, 180.0 - mean), 1e-9);
  EXPECT_NEAR(near_x.directions.groups.at(3).sectors.at(0), 1.0, 1e-12);
  EXPECT_NEAR(near_x.directions.groups.at(3).deviation.value(), 1.0, 1e-3);

  const JointStatistics weighted = joint_statistics(fan({20, 40}, {3, 1}));
  EXPECT_NEAR(weighted.directions.groups.at(3).sectors.at(2), 0.75, 1e-12);
  EXPECT_NEAR(weighted.directions.groups.at(3).sectors.at(4), 0.25, 1e-12);
  EXPECT_NEAR(weighted.directions.groups.at(3).mean, 24.9, 0.2);

  const JointStatistics all = joint_statistics(fan({0, 45, 90, 135}, {1, 1, 1, 1}));
  EXPECT_FALSE(all.directions.groups.at(3).deviation.has_value());
}

/// Returns CIELAB coordinates of linear sRGB.
Eigen::Vector3d lab(const Eigen::Vector3d& linear) {
  const Eigen::Matrix3d to_xyz = (Eigen::Matrix3d() << 0.4124, 0.3576, 0.1805, 0.2126,
                                  0.7152, 0.0722, 0.0193, 0.1192, 0.9505)
                                     .finished();
  const Eigen::Vector3d d65(0.95047, 1.0, 1.08883);
  const Eigen::Vector3d xyz =
      (to_xyz * linear.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(d65);
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  return {116 * f(xyz[1]) - 16, 500 * (f(xyz[0]) - f(xyz[1])),
          200 * (f(xyz[1]) - f(xyz[2]))};
}

Eigen::Vector3d linear(const Colour& c) {
  const auto of = [](double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return {of(c.r), of(c.g), of(c.b)};
}

// The matrices simulate complete colour blindness (Machado, Oliveira, Fernandes 2009).
TEST(JointsInFigure, ColoursDifferForColourBlindReadersAndAsGreys) {
  const std::array<Eigen::Matrix3d, 4> readers = {
      Eigen::Matrix3d::Identity(),
      (Eigen::Matrix3d() << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216,
       -0.003882, -0.048116, 1.051998)
          .finished(),
      (Eigen::Matrix3d() << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413,
       -0.011820, 0.042940, 0.968881)
          .finished(),
      (Eigen::Matrix3d() << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809,
       0.147602, 0.004733, 0.691367, 0.303900)
          .finished()};
  constexpr double clearly = 17.0;  // 2.3 is just noticeable
  for (const Eigen::Matrix3d& eye : readers)
    for (int a = 1; a <= 8; ++a)
      for (int b = 1; b < a; ++b)
        EXPECT_GT(
            (lab(eye * linear(joint_colour(a))) - lab(eye * linear(joint_colour(b))))
                .norm(),
            clearly)
            << "joints " << a << " and " << b;
  for (int a = 1; a <= 4; ++a)
    for (int b = 1; b < a; ++b)
      EXPECT_GT(
          std::abs(lab(linear(joint_colour(a)))[0] - lab(linear(joint_colour(b)))[0]),
          14.0);
}

}  // namespace
}  // namespace blocks::post

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A square of 4 x 4 with horizontal joints 1 and vertical joints 2, a unit apart.
const std::string square_of_joints = preliminary() +
                                     "OUTLINE, 4, 1\n0, 0, 4, 4\n0, 4, 4, 0\n"
                                     "JSET, 1, 0, , 1, , , , , , 0, 0.5\n"
                                     "JSET, 2, 90, , 1, , , , , , 0.5, 0\n"
                                     "CUT\nPLOTS, 0.004\nCYCLE, 10\n";

class PlotOfJoints : public ::testing::Test {
 protected:
  void SetUp() override { run_text(folder_, "cut", square_of_joints); }
  Outcome plot(const std::string& arguments) const {
    return blocks("plot " + arguments, folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(PlotOfJoints, DrawsRoseAndHistogramsInEveryFormat) {
  const Outcome usual = plot("cut.vtkhdf --joints");
  EXPECT_EQ(usual.code, 0) << usual.err;
  EXPECT_EQ(usual.out, "cut_joints.png\n");
  EXPECT_EQ(plot("cut.vtkhdf --joints -o cut.pdf --size single").code, 0);
  ASSERT_EQ(plot("cut.vtkhdf --joints -o cut.svg --units m,kg,s").code, 0);
  const std::string svg = slurp(folder_ / "cut.svg");
  for (const char* words :
       {"25 blocks at joints", "joint 1", "joint 2", "0.0° ± 0.0°, 50 % of the length",
        "90.0° ± 0.0°, 50 % of the length", "area [m²]", "aspect ratio",
        "number of sides", "median 0.5 m²", "mean 4"})
    EXPECT_THAT(svg, HasSubstr(words));
}

TEST_F(PlotOfJoints, ListsTheJointsInTheLegend) {
  ASSERT_EQ(plot("cut.vtkhdf --colour JOINT -o cut.svg").code, 0);
  const std::string svg = slurp(folder_ / "cut.svg");
  for (const char* words : {"joint 1", "joint 2", "no joint", "material 1"})
    EXPECT_THAT(svg, HasSubstr(words));
  EXPECT_THAT(svg, Not(HasSubstr("joint 3")));
}

TEST_F(PlotOfJoints, RefusesWhatHasNoEffect) {
  const auto expect_refusal = [&](const std::string& arguments,
                                  const std::string& words) {
    const Outcome run = plot(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_THAT(run.err, HasSubstr(words)) << arguments;
  };
  expect_refusal("cut.vtkhdf --joints --forces", "--joints and --forces exclude");
  expect_refusal("cut.vtkhdf --joints --colour joint", "--joints and --colour exclude");
  expect_refusal("cut.vtkhdf --joints -t 0,1", "--joints draws one time");
  expect_refusal("cut.vtkhdf --joints -o a.mp4", "--joints is for a figure");
  expect_refusal("cut.vtkhdf --joints --size 85mmx60mm", "choose a larger size");
  expect_refusal("cut.vtkhdf --colour joint --range 0,1", "--range is for");
  run_text(folder_, "plain", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 10\n");
  expect_refusal("plain.vtkhdf --joints", "no side of a block has a joint id");
  expect_refusal("plain.vtkhdf --colour joint", "\n  hint: blocks get joint ids from");
}

}  // namespace
}  // namespace blocks::testing
