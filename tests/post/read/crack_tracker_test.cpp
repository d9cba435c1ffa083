// The places of pieces in the first frame, and the sides that are faces of cracks. The
// frames are made by hand from a motion that is known.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

#include "post/read/crack_tracker.hpp"
#include "post/read/piece_families.hpp"

namespace blocks::testing {
namespace {

using Vector = Eigen::Vector2d;
using Outline = std::vector<Vector>;
constexpr double tolerance = 1e-12;

/// A part of the material, which moves evenly from each of its starts to the next one.
struct Body {
  Outline outline;  ///< in the first frame
  Vector centroid;  ///< in the first frame
  struct Motion {
    double begin;  ///< [T]
    Vector velocity;
    double spin;
  };
  std::vector<Motion> motions;

  double angle(double time) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i)
      sum += motions[i].spin * duration(i, time);
    return sum;
  }
  /// Pieces turn about the centroid of the block before the crack, and about their own
  /// one after it.
  Vector place(const Vector& p, double time) const {
    Vector at = p, middle = whole;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (i == 1)
        middle = moved_centroid;
      const double turn = motions[i].spin * duration(i, time);
      at = middle + Eigen::Rotation2Dd(turn) * (at - middle) +
           motions[i].velocity * duration(i, time);
    }
    return at;
  }
  Vector whole = Vector::Zero();           ///< centroid of the block before the crack
  Vector moved_centroid = Vector::Zero();  ///< of the piece at the crack

 private:
  double duration(std::size_t i, double time) const {
    const double end = i + 1 < motions.size() ? motions[i + 1].begin : time;
    return std::max(0.0, std::min(time, end) - motions[i].begin);
  }
};

post::Frame frame_of(const std::vector<Body>& bodies, double time, long cracks) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  post::Frame frame;
  frame.time = time;
  frame.cracks = cracks;
  for (auto* plane : {&frame.centroid, &frame.velocity, &frame.force})
    plane->setZero(2, n);
  for (auto* column : {&frame.angle, &frame.spin})
    column->setZero(n);
  for (Eigen::Index b = 0; b < n; ++b) {
    const Body& body = bodies[static_cast<std::size_t>(b)];
    frame.number.push_back(static_cast<int>(b) + 1);
    frame.material.push_back(1);
    frame.fixed.push_back(0);
    Outline outline;
    for (const Vector& p : body.outline)
      outline.push_back(body.place(p, time));
    frame.outlines.push_back(outline);
    frame.centroid.col(b) = body.place(body.centroid, time);
    frame.angle[b] = body.angle(time);
    for (const Body::Motion& motion : body.motions)
      if (time >= motion.begin) {
        frame.velocity.col(b) = motion.velocity;
        frame.spin[b] = motion.spin;
      }
  }
  return frame;
}

post::Crack crack_of(double time, int parent, int child, const Vector& from,
                     const Vector& to) {
  post::Crack crack;
  crack.time = time;
  crack.parent = parent, crack.child = child;
  crack.from = from, crack.to = to;
  return crack;
}

/// A rectangle of 2 x 1 that flies and spins evenly, splits at the time 0.35 across its
/// middle, and whose halves fly on with other velocities.
struct Split {
  static constexpr double time = 0.35;
  Body whole{{{0, 0}, {0, 1}, {2, 1}, {2, 0}}, {1, 0.5}, {{0.0, {3, 1}, 0.7}}};
  Body left{{{0, 0}, {0, 1}, {1, 1}, {1, 0}},
            {0.5, 0.5},
            {{0.0, {3, 1}, 0.7}, {time, {2.0, 1.5}, -0.4}}};
  Body right{{{1, 1}, {2, 1}, {2, 0}, {1, 0}},
             {1.5, 0.5},
             {{0.0, {3, 1}, 0.7}, {time, {4.0, 0.5}, -0.4}}};
  post::Crack crack;

  Split() {
    whole.whole = whole.centroid;
    for (Body* piece : {&left, &right}) {
      piece->whole = whole.centroid;
      piece->moved_centroid = whole.place(piece->centroid, time);
    }
    crack = crack_of(time, 1, 2, whole.place({1, 0}, time), whole.place({1, 1}, time));
  }
};

// The motion is even before and after the crack, so the places are exact whenever the
// frames are.
TEST(CrackTracker, FindsWhereThePiecesWereInTheFirstFrame) {
  const Split split;
  const post::Frame first = frame_of({split.whole}, 0.0, 0),
                    before = frame_of({split.whole}, 0.3, 0),
                    after = frame_of({split.left, split.right}, 0.6, 1);
  post::CrackTracker tracker(first, {split.crack});
  ASSERT_TRUE(tracker.is_behind(after));
  tracker.advance(before, after);
  ASSERT_FALSE(tracker.is_behind(after));
  const post::CrackedBlocks& blocks = tracker.blocks();
  const Body* const bodies[] = {&split.left, &split.right};
  for (int b = 0; b < 2; ++b) {
    const auto k = static_cast<std::size_t>(b);
    EXPECT_LT((blocks.first.centroid.col(b) - bodies[b]->centroid).norm(), tolerance);
    ASSERT_EQ(blocks.first.outlines[k].size(), 4U);
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_LT((blocks.first.outlines[k][c] - bodies[b]->outline[c]).norm(), tolerance)
          << b << " " << c;
  }
  EXPECT_EQ(blocks.faces, (std::vector<std::vector<int>>{{0, 0, 1, 0}, {0, 0, 0, 1}}));
  EXPECT_EQ(blocks.version, (std::vector<int>{1, 1}));
}

// A later crack cuts the face of an earlier one, and both parts remain its faces. So it
// is whether a frame lies between the cracks or not.
TEST(CrackTracker, KeepsTheFacesOfEarlierCracks) {
  Split split;
  // The right half, which does not spin, splits again along y = 0.5 at the time 0.45.
  split.right.motions[1].spin = 0.0;
  Body low = split.right, high = split.right;
  low.outline = {{1, 0.5}, {2, 0.5}, {2, 0}, {1, 0}};
  high.outline = {{1, 1}, {2, 1}, {2, 0.5}, {1, 0.5}};
  low.centroid = {1.5, 0.25}, high.centroid = {1.5, 0.75};
  const post::Crack second = crack_of(0.45, 2, 3, split.right.place({1, 0.5}, 0.45),
                                      split.right.place({2, 0.5}, 0.45));
  const std::vector<post::Crack> cracks = {split.crack, second};
  const post::Frame first = frame_of({split.whole}, 0.0, 0),
                    before = frame_of({split.whole}, 0.3, 0),
                    between = frame_of({split.left, split.right}, 0.4, 1),
                    after = frame_of({split.left, low, high}, 0.5, 2);
  const std::vector<std::vector<int>> faces = {
      {0, 0, 1, 0}, {2, 0, 0, 1}, {0, 0, 2, 1}};
  post::CrackTracker one_by_one(first, cracks), at_once(first, cracks);
  one_by_one.advance(before, between);
  one_by_one.advance(between, after);
  at_once.advance(before, after);
  EXPECT_EQ(one_by_one.blocks().faces, faces);
  EXPECT_EQ(at_once.blocks().faces, faces);
  EXPECT_EQ(one_by_one.blocks().version, (std::vector<int>{1, 2, 1}));
  for (int b = 0; b < 3; ++b)
    EXPECT_LT((one_by_one.blocks().first.centroid.col(b) -
               std::vector<Vector>{
                   {0.5, 0.5}, {1.5, 0.25}, {1.5, 0.75}}[static_cast<std::size_t>(b)])
                  .norm(),
              tolerance);
}

// Blocks that the deck makes between two motions have no displacement, also if they
// split; those of cracks do.
TEST(CrackTracker, TellsPiecesFromBlocksThatWereMadeLater) {
  const Split split;
  Body other = split.whole;
  for (Vector& p : other.outline)
    p.x() += 10;
  other.centroid.x() += 10;
  const post::Frame first = frame_of({split.whole}, 0.0, 0),
                    before = frame_of({split.whole, other}, 0.3, 0);
  post::Crack crack = split.crack;
  crack.child = 3;
  const post::Frame after = frame_of({split.left, other, split.right}, 0.4, 1);
  post::CrackTracker tracker(first, {crack});
  tracker.advance(first, before);
  EXPECT_TRUE(tracker.blocks().first.centroid.col(1) == before.centroid.col(1));
  tracker.advance(before, after);
  EXPECT_TRUE(tracker.blocks().first.centroid.col(1) == after.centroid.col(1));
  EXPECT_LT((tracker.blocks().first.centroid.col(2) - split.right.centroid).norm(),
            tolerance);
  EXPECT_EQ(tracker.blocks().later, (std::vector<char>{0, 1, 0}));
}

// Block 3 has split twice, and one of its pieces too; block 2 is whole.
TEST(Families, FollowParentsToTheBlockOfTheDeck) {
  post::Frame frame;
  frame.number = {1, 2, 3, 4, 5, 6, 7};
  frame.parent = {0, 0, 0, 3, 3, 5, 1};
  EXPECT_EQ(post::families_of(frame), (std::vector<int>{1, 0, 3, 3, 3, 3, 1}));
  frame.parent.clear();
  EXPECT_EQ(post::families_of(frame), std::vector<int>(7, 0));
}

}  // namespace
}  // namespace blocks::testing
