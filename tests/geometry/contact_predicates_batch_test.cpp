// The batch form of the predicates gives the same answers as the scalar form and leaves
// the same lanes to exact arithmetic.
#include "geometry/contact_predicates_batch.hpp"

#include "contact_judge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace blocks::geometry {
namespace {

/// Returns random corners, flush bricks, corners on limits, or corners of any
/// magnitude. The bricks are turned or not, and near the origin or far away.
Case any_kind(Random& random) {
  Case k = random.whole(0, 2) ? wall(random) : random.any(1);
  const int kind = random.whole(0, 5);
  if (kind == 1 || kind == 2) {
    const Vec2 turn = random.vector(1);
    const Vec2 origin =
        random.vector(kind == 1 ? 0 : std::pow(10, random.whole(0, 15)));
    k.transform([&](const Vec2& v) {
      return Vec2(origin.x() + (turn.x() * v.x() - turn.y() * v.y()),
                  origin.y() + (turn.y() * v.x() + turn.x() * v.y()));
    });
  } else if (kind == 3) {
    const double s = random.whole(0, 1) ? contact_slack : 1 + contact_slack;
    const Vec2 e = k.p2 - k.p1;
    k.c = random.nudge(k.p1 + s * e + random.whole(0, 1) * Vec2(-e.y(), e.x()), 2);
    k.q1 = k.p2;
    k.neighbour =
        k.c + e +
        std::tan(random.whole(-1, 1) * 0.17453292519943295) * Vec2(e.y(), -e.x());
  } else if (kind == 4) {
    const double size = std::ldexp(1, random.whole(-1074, 1023));
    k.transform([&](const Vec2& v) -> Vec2 { return v * size; });
  } else if (kind == 5) {
    k.transform([&](const Vec2& v) -> Vec2 {
      return v * std::ldexp(1, random.whole(-1074, 1023));
    });
  }
  return k;
}

struct Batch {
  std::array<Case, batch_lanes> cases;
  Points c, p1, p2, q1, q2, centroid, neighbour;

  explicit Batch(Random& random) {
    for (std::size_t i = 0; i < batch_lanes; ++i) {
      Case k = any_kind(random);
      while (!k.proper())
        k = any_kind(random);
      cases[i] = k;
      c.set(i, k.c), p1.set(i, k.p1), p2.set(i, k.p2), q1.set(i, k.q1);
      q2.set(i, k.q2), centroid.set(i, k.centroid), neighbour.set(i, k.neighbour);
    }
  }
};

struct Count {
  long sure = 0, undecided = 0;
};

/// Requires that the batch form decides exactly the lanes where the scalar form needs
/// no exact arithmetic, with the same answers.
template <class Scalar>
void compare(const Answers& found, const Batch& b, Count& count, Scalar&& scalar) {
  for (std::size_t i = 0; i < batch_lanes; ++i) {
    const auto before = exact::calls();
    const int answer = scalar(b.cases[i]);
    const bool asked = exact::calls() != before;
    ASSERT_EQ(found.undecided(i), asked) << i;
    ASSERT_NE(found.undecided(i), found.yes(i) || found.no(i)) << i;
    ASSERT_FALSE(found.yes(i) && found.no(i)) << i;
    ASSERT_TRUE(asked || found.yes(i) == (answer > 0)) << i;
    ++(asked ? count.undecided : count.sure);
  }
}

TEST(ContactPredicatesBatch, AgreesWithTheScalarForm) {
  Random random;
  std::array<Count, 6> counts;
  for (int n = 0; n < 20000; ++n) {
    const Batch b(random);
    compare(batch::overlap_sign(b.c, b.p1, b.p2), b, counts[0],
            [](const Case& k) { return overlap_sign(k.c, k.p1, k.p2); });
    compare(batch::near_or_inside(b.c, b.p1, b.p2), b, counts[1],
            [](const Case& k) { return near_or_inside(k.c, k.p1, k.p2); });
    compare(batch::between(b.c, b.p1, b.p2), b, counts[2],
            [](const Case& k) { return between(k.c, k.p1, k.p2); });
    compare(batch::within_depth(b.c, b.centroid, b.p1, b.p2), b, counts[3],
            [](const Case& k) { return within_depth(k.c, k.centroid, k.p1, k.p2); });
    compare(batch::faces_edge(b.c, b.neighbour, b.p1, b.p2), b, counts[4],
            [](const Case& k) { return faces_edge(k.c, k.neighbour, k.p1, k.p2); });
    compare(batch::compare_depth(b.c, b.p1, b.p2, b.q1, b.q2), b, counts[5],
            [](const Case& k) { return compare_depth(k.c, k.p1, k.p2, k.q1, k.q2); });
    ASSERT_FALSE(HasFailure()) << "batch " << n;
    const Answers reach = batch::in_reach_of_edge(b.c, b.centroid, b.p1, b.p2);
    for (std::size_t i = 0; i < batch_lanes; ++i) {
      const Case& k = b.cases[i];
      const bool answer = in_reach_of_edge(k.c, k.centroid, k.p1, k.p2);
      ASSERT_TRUE(reach.undecided(i) || reach.yes(i) == answer) << n;
    }
  }
  for (const Count& count : counts) {
    EXPECT_GT(count.sure, 10000);
    EXPECT_GT(count.undecided, 1000);
  }
}

TEST(ContactPredicatesBatch, CornerIsInsideABlockIfItIsInsideAllEdges) {
  Random random;
  int inside = 0, on_edge = 0;
  for (int n = 0; n < 40000; ++n) {
    const Case k = wall(random);
    const double cosine = n % 4 ? random.uniform(-1, 1) : 1;
    const double sine = n % 4 ? random.uniform(-1, 1) : 0;
    const Vec2 origin = random.vector(n % 3 ? 0 : 1e9);
    const auto turned = [&](double x, double y) {
      return Vec2(origin.x() + (cosine * x - sine * y),
                  origin.y() + (sine * x + cosine * y));
    };
    const double x = k.p1.x(), y = k.p2.y() - 1;
    Points p1, p2;
    const std::array<Vec2, 4> brick{turned(x, y), turned(x, y + 1),
                                    turned(x + 2, y + 1), turned(x + 2, y)};
    for (std::size_t i = 0; i < 4; ++i)
      p1.set(i, brick[i]), p2.set(i, brick[(i + 1) % 4]);
    // Every fifth corner is on the limit of the slack above the brick.
    const Vec2 c = n % 5 ? turned(k.c.x(), k.c.y())
                         : turned(x + random.uniform(0, 2), y + 1 + 2 * contact_slack);
    bool all = true, undecided = false;
    const Answers found = batch::near_or_inside(Points::all(c), p1, p2);
    for (std::size_t i = 0; i < 4; ++i) {
      all = all && near_or_inside(c, p1[i], p2[i]);
      undecided = undecided || found.undecided(i);
    }
    ASSERT_EQ(near_or_inside_all(c, p1, p2), all) << n;
    inside += all;
    on_edge += undecided;
  }
  EXPECT_GT(inside, 4000);
  EXPECT_LT(inside, 36000);
  EXPECT_GT(on_edge, 100);
}

}  // namespace
}  // namespace blocks::geometry
