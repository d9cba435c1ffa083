// What a third polygon means for an axis of two others: configurations whose answer is
// known, in many exact frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/continuation.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

/// A map of the plane that is exact for coordinates that are multiples of 2^-20: a
/// rotation by a Pythagorean angle times 25, an optional reflection, and a shift.
struct ExactFrame {
  int cosine, sine;
  bool mirrored;
  double shift;
  Vec2 operator()(const Vec2& p) const {
    const double x = mirrored ? -p.x() : p.x();
    return {cosine * x - sine * p.y() + shift, sine * x + cosine * p.y() - shift};
  }
  Polygon operator()(Polygon polygon) const {
    for (Vec2& p : polygon)
      p = (*this)(p);
    if (mirrored)
      std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }
};

std::vector<ExactFrame> exact_frames() {
  std::vector<ExactFrame> frames;
  const int rotations[][2] = {{25, 0},  {0, 25},  {15, 20},
                              {-24, 7}, {7, -24}, {-20, -15}};
  for (const auto& [cosine, sine] : rotations)
    for (const bool mirrored : {false, true})
      for (const double shift : {0.0, 1024.0, 1048576.0})
        frames.push_back({cosine, sine, mirrored, shift});
  return frames;
}

/// Two polygons, a side of the first one and a corner of the second one, by their
/// points, and a third polygon.
struct Configuration {
  Polygon own, other, third;
  Vec2 from, to;  ///< ends of the axis side
  Vec2 corner;
  bool faces = false;  ///< the side of `other` that starts or ends there faces the side
};

int index_of(const Polygon& polygon, const Vec2& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (polygon[i] == point)
      return static_cast<int>(i);
  ADD_FAILURE() << "no corner at this point";
  return 0;
}

/// Calls ask(axis, third) in each frame and expects the same answer.
template <class Ask>
void expect_in_all_frames(const Configuration& c, bool expected, const Ask& ask) {
  for (const ExactFrame& frame : exact_frames()) {
    const Polygon own = frame(c.own), other = frame(c.other), third = frame(c.third);
    PolygonAxis axis{own, 0, other, index_of(other, frame(c.corner)), -1};
    axis.side = index_of(own, frame(frame.mirrored ? c.to : c.from));
    if (c.faces) {
      // Of the two sides at the corner, the one that runs more against the axis side.
      const Vec2 along = frame(c.to) - frame(c.from);
      const int count = static_cast<int>(other.size());
      const int before = (axis.corner + count - 1) % count;
      const auto against = [&](int i) {
        const Vec2 side = other[static_cast<std::size_t>((i + 1) % count)] -
                          other[static_cast<std::size_t>(i)];
        return -along.normalized().dot(side.normalized()) * (frame.mirrored ? -1 : 1);
      };
      axis.facing = against(before) > against(axis.corner) ? before : axis.corner;
    }
    EXPECT_EQ(ask(axis, third), expected)
        << "rotation " << frame.cosine << ' ' << frame.sine << " mirrored "
        << frame.mirrored << " shift " << frame.shift;
  }
}
bool hidden_by_own(const PolygonAxis& axis, Outline third) {
  return is_hidden_by(axis, third, Continues::own);
}

constexpr double h = 0x1p-6;  ///< depth of the slider in the floor
constexpr double d = 0x1p-8;  ///< how far the slider is in the next box

/// A slider on the box [-4, 0] of a floor, sunk in by h, that has entered the next box,
/// whose top is at `top`, by d through its left side.
Configuration slider(double top) {
  Configuration c;
  c.own = {{0, -1}, {0, top}, {4, top}, {4, -1}};
  c.other = {{-1, -h}, {-1, 1}, {d, 1}, {d, -h}};
  c.third = {{-4, -1}, {-4, 0}, {0, 0}, {0, -1}};
  c.from = {0, -1}, c.to = {0, top}, c.corner = {d, -h}, c.faces = true;
  return c;
}

TEST(Continuation, ASideBetweenFlushBoxesIsHidden) {
  expect_in_all_frames(slider(0.0), true, hidden_by_own);
}

TEST(Continuation, ALedgeLowerThanTheOverlapIsHiddenAndAHigherOneIsNot) {
  expect_in_all_frames(slider(0.5 * h), true, hidden_by_own);
  expect_in_all_frames(slider(1.5 * h), false, hidden_by_own);
  expect_in_all_frames(slider(2.0), false, hidden_by_own);
}

TEST(Continuation, AGapUpToTwiceTheOverlapClosesAJoint) {
  for (const double gap : {0.5 * h, 1.5 * h, 2.5 * h}) {
    Configuration c = slider(0.0);
    for (Vec2& p : c.third)
      p.x() -= gap;
    expect_in_all_frames(c, gap < 2.0 * h, hidden_by_own);
  }
}

// The top of the next box carries the slider, although the first box is beside it.
TEST(Continuation, TheTopOfTheNextBoxIsNotHidden) {
  Configuration c = slider(0.0);
  c.from = {0, 0}, c.to = {4, 0};
  expect_in_all_frames(c, false, hidden_by_own);
}

// A stake with flanks of 45 degrees is just right of the joint of two flush boxes. Its
// right flank is less deep than the top of the box, but the corner of the box is not a
// corner of the floor.
TEST(Continuation, TheCornerOfAFlushBoxIsHiddenFromAFlank) {
  Configuration c;
  c.own = {{d, -h}, {d - 2, 2 - h}, {d + 2, 2 - h}};
  c.other = {{0, -1}, {0, 0}, {4, 0}, {4, -1}};
  c.third = {{-4, -1}, {-4, 0}, {0, 0}, {0, -1}};
  c.from = {d + 2, 2 - h}, c.to = {d, -h}, c.corner = {0, 0};
  const auto ask = [](const PolygonAxis& axis, Outline third) {
    return is_hidden_by(axis, third, Continues::other);
  };
  expect_in_all_frames(c, true, ask);
  // Without the first box the corner is one of the floor.
  c.third = {{-4, -3}, {-4, -2}, {0, -2}, {0, -3}};
  expect_in_all_frames(c, false, ask);
}

/// The tip of a wedge below the bottom of a notch of two boxes with flanks of 45
/// degrees, right of the joint. The axis is that of the left flank.
Configuration notch() {
  Configuration c;
  c.own = {{-4, -2}, {-4, 4}, {0, 0}, {0, -2}};
  c.other = {{d, -h}, {d - 1, 3 - h}, {d + 1, 3 - h}};
  c.third = {{0, -2}, {0, 0}, {4, 4}, {4, -2}};
  c.from = {-4, 4}, c.to = {0, 0}, c.corner = {d, -h};
  return c;
}

TEST(Continuation, AFlankHasNoEndAtTheBottomOfANotch) {
  expect_in_all_frames(notch(), false, hidden_by_own);
  expect_in_all_frames(notch(), true, [](const PolygonAxis& axis, Outline third) {
    return is_in_notch_of(axis, third);
  });
  Configuration flat = notch();
  flat.third = {{0, -2}, {0, -1}, {4, -1}, {4, -2}};
  expect_in_all_frames(flat, false, [](const PolygonAxis& axis, Outline third) {
    return is_in_notch_of(axis, third);
  });
}

// Crossing, the common region and the separating shift of two boxes.
TEST(Continuation, MeasuresTheCommonRegion) {
  const Polygon one = {{0, 0}, {0, 4}, {4, 4}, {4, 0}},
                other = {{3, 3}, {3, 8}, {8, 8}, {8, 3}};
  EXPECT_TRUE(crosses(one, 1, other));
  EXPECT_FALSE(crosses(one, 0, other));
  const Polygon flush = {{4, 0}, {4, 4}, {8, 4}, {8, 0}};
  EXPECT_TRUE(crosses(one, 2, flush));   // the common side, borders included
  EXPECT_FALSE(crosses(one, 1, flush));  // a common end has no length
  // The diagonal of the region is 1.414, so twice that is 2.828.
  const auto far = [&](double depth) {
    return exceeds_common_region({10, -depth}, {9, 0}, {11, 0}, one, other);
  };
  EXPECT_FALSE(far(2.8));
  EXPECT_TRUE(far(2.83));
  const auto beyond_shift = [&](double depth) {
    return exceeds_separating_shift({10, -depth}, {9, 0}, {11, 0}, one, other);
  };
  EXPECT_FALSE(beyond_shift(2.0));
  EXPECT_TRUE(beyond_shift(2.001));
  EXPECT_TRUE(exceeds_separating_shift({10, -0.001}, {9, 0}, {11, 0}, one, flush));
}

}  // namespace
}  // namespace blocks::geometry
