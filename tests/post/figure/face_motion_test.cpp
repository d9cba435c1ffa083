// Opening and shear displacement of faces follow from the places of the blocks.
#include "post/read/face_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "post/figure/figure_page.hpp"
#include "post/figure/sides.hpp"

namespace blocks::post {
namespace {

using Vector = Eigen::Vector2d;

/// Adds a rectangle with its lower left corner at `at`.
void add(Frame& frame, const Vector& at, double width, double height) {
  frame.number.push_back(frame.size() + 1);
  frame.outlines.push_back(
      {at, at + Vector(0, height), at + Vector(width, height), at + Vector(width, 0)});
  frame.material.push_back(1);
  frame.fixed.push_back(0);
}

/// A floor with two bricks side by side on it.
Frame bricks() {
  Frame frame;
  add(frame, {-1, -1}, 6, 1);
  add(frame, {0, 0}, 2, 1);
  add(frame, {2, 0}, 1, 1);
  frame.centroid = (Eigen::Matrix2Xd(2, 3) << 2, 1, 2.5, -0.5, 0.5, 0.5).finished();
  return frame;
}

void move(Frame& frame, std::size_t block, const Vector& way) {
  for (Vector& p : frame.outlines[block])
    p += way;
}

void turn(Frame& frame, std::size_t block, double angle, const Vector& about) {
  for (Vector& p : frame.outlines[block])
    p = about + Eigen::Rotation2Dd(angle) * (p - about);
}

/// Returns the motion of the face of two blocks, from 0; none if it is not one any
/// more.
std::optional<FaceMotion> between(int a, int b, const Frame& now,
                                  const Frame& first = bricks()) {
  for (const Face& face : find_faces(first, {}))
    if (std::minmax(face.own.block, face.other.block) == std::minmax(a, b))
      return motion_of(face, now);
  ADD_FAILURE() << "blocks " << a << " and " << b << " have no face";
  return std::nullopt;
}

void expect(const std::optional<FaceMotion>& motion, double opening, double shear) {
  ASSERT_TRUE(motion);
  for (int end = 0; end < 2; ++end) {
    EXPECT_NEAR(motion->opening[end], opening, 1e-14);
    EXPECT_NEAR(motion->shear[end], shear, 1e-14);
  }
}

TEST(FaceMotion, FacesAreThePartsThatSidesHaveInCommon) {
  const std::vector<Face> faces = find_faces(bricks(), {});
  std::vector<double> lengths;
  for (const Face& face : faces)
    lengths.push_back((face.own.at(bricks(), 1) - face.own.at(bricks(), 0)).norm());
  EXPECT_THAT(lengths, ::testing::UnorderedElementsAre(2.0, 1.0, 1.0));
  EXPECT_EQ(find_faces(bricks(), {0, 0, 1}).size(), 1u) << "block 3 was made later";
  Frame apart = bricks();
  move(apart, 2, {0.02, 0});
  EXPECT_EQ(find_faces(apart, {}).size(), 2u) << "the bricks do not touch";
}

TEST(FaceMotion, OpeningIsPositiveApartAndShearIsPositiveToTheRight) {
  Frame now = bricks();
  move(now, 2, {0.003, 0.02});  // seen from brick 2, brick 3 moves to the left
  expect(between(1, 2, now), 0.003, -0.02);
  expect(between(0, 2, now), 0.02, 0.003);
  expect(between(0, 1, now), 0, 0);
  move(now, 1, {0.004, 0});
  expect(between(1, 2, now), -0.001, -0.02);
}

TEST(FaceMotion, ATurnOfAllBlocksIsNone) {
  Frame now = bricks();
  for (std::size_t b = 0; b < 3; ++b)
    turn(now, b, 2.0, {5, 7});
  for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 2}})
    expect(between(a, b, now), 0, 0);
}

TEST(FaceMotion, ABlockThatTipsOpensItsFaceLinearly) {
  Frame now = bricks();
  turn(now, 1, 0.01, {0, 0});  // about the left end of the floor's face
  const auto motion = between(0, 1, now);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->opening.maxCoeff(), 2 * 0.01, 1e-4);
  EXPECT_NEAR(motion->opening.minCoeff(), 0, 1e-14);
}

TEST(FaceMotion, TheGapOfTheFirstFrameDoesNotCount) {
  Frame first = bricks(), now = bricks();
  move(first, 1, {0, -0.001});
  expect(between(0, 1, now, first), 0.001, 0);
}

TEST(FaceMotion, EndsWhereSidesDoNotFaceEachOtherAnyMore) {
  Frame now = bricks();
  move(now, 2, {0, 0.99});
  EXPECT_TRUE(between(1, 2, now));
  move(now, 2, {0, 0.02});
  EXPECT_FALSE(between(1, 2, now));
  now = bricks();
  turn(now, 1, 0.4, {0, 0});
  EXPECT_FALSE(between(0, 1, now));
  now = bricks();
  now.outlines[1].clear();
  EXPECT_FALSE(between(0, 1, now)) << "it is removed";
}

// Seen in a mirror, the other block moves to the other side.
TEST(FaceFigure, HasTheValuesOfFaces) {
  Frame now = bricks();
  move(now, 2, {0.003, 0.02});
  FigureOptions options;
  const auto scales = [&] {
    const Frame first = bricks();
    ScaleSurvey survey(options);
    survey.include({now, first, {}});
    return survey.scales();
  };
  options.colour = "opening";
  EXPECT_NEAR(scales().colours.high, 0.02, 1e-14);
  EXPECT_EQ(scales().colours.low, 0.0);
  options.colour = "shear_displacement";
  EXPECT_NEAR(scales().colours.low, -0.02, 1e-14);
  now = bricks();
  move(now, 1, {0.01, 0});
  EXPECT_EQ(scales().colours.low, 0.0);
  options.mirror = true, options.mirror_x = -1;
  EXPECT_NEAR(scales().colours.low, -0.01, 1e-14);
}

TEST(FaceFigure, IsRefusedWithoutFaces) {
  Frame alone;
  add(alone, {0, 0}, 1, 1);
  FigureOptions options;
  options.colour = "opening";
  ScaleSurvey survey(options);
  survey.include({alone, alone, {}});
  EXPECT_THAT([&] { survey.scales(); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  ::testing::HasSubstr("no two blocks have a common face")));
}

}  // namespace
}  // namespace blocks::post
