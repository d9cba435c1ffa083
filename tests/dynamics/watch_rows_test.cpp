// A quick look that says all corners stay is right, and rows come and go in their room.
#include "dynamics/watch_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

using geometry::Vec2;

/// Corners near the edges of a few bricks, many within the slack or a unit in the last
/// place of its limit.
struct Corners {
  static constexpr int count = 40;
  std::vector<double> xy = std::vector<double>(2 * count);
  double none[2] = {};

  explicit Corners(std::mt19937_64& random) {
    for (double& x : xy) {
      x = static_cast<double>(random() % 4);
      switch (random() % 4) {
      case 0:
        x += (random() % 2 == 0 ? 1.0 : -1.0) * geometry::contact_slack;
        break;
      case 1:
        x = std::nextafter(x, 9.0);
        break;
      case 2:
        x += std::ldexp(1.0, -static_cast<int>(random() % 50));
        break;
      default:
        break;
      }
    }
  }
  Vec2 at(int c) const { return {xy[2 * c], xy[2 * c + 1]}; }
  BlockRows rows() const { return {xy.data(), none, none, none, none}; }
};

TEST(WatchRows, WhoIsSaidToStayStays) {
  std::mt19937_64 random(3);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  long stay = 0, unsure = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Corners corners(random);
    WatchRows rows;
    rows.reserve(1, 32);
    WatchRows::Maker maker;
    bool all = true;
    for (int k = 1 + below(WatchRows::most * lane_count); k > 0; --k) {
      const int c = below(Corners::count), p1 = below(Corners::count);
      const int p2 = below(Corners::count);
      const bool inside = geometry::exact::near_or_inside(corners.at(c), corners.at(p1),
                                                          corners.at(p2));
      const bool other = below(60) == 0;
      all = all && !other;
      maker.add(c, p1, p2, inside == other);
    }
    maker.finish(rows, 0);
    ASSERT_FALSE(rows.missing(0));
    for (const LaneArithmetic& arithmetic : all_lane_arithmetic()) {
      const bool said =
          rows.all_stay(0, arithmetic, corners.rows(), geometry::contact_slack);
      ASSERT_TRUE(all || !said) << arithmetic.name << ' ' << trial;
      stay += said, unsure += all && !said;
    }
  }
  EXPECT_GT(stay, 1000);
  EXPECT_GT(unsure, 1000);  // corners on the limit itself
}

TEST(WatchRows, RoomIsSharedByAWindow) {
  std::mt19937_64 random(4);
  const Corners corners(random);
  constexpr int window = 32, rounds = 2 * window;
  WatchRows rows;
  rows.reserve(rounds, window);
  const auto make = [&](int round, int edges) {
    WatchRows::Maker maker;
    for (int k = 0; k < edges; ++k)  // far inside a square of its own round
      maker.add(0, 1, 2, false);
    maker.finish(rows, round);
  };
  const double square[] = {0.5, 0.5 + 1.0, 0.0, 2.0, 9.0, 2.0};
  const BlockRows there{square, square, square, square, square};
  const auto stays = [&](int round) {
    return rows.all_stay(round, lane_arithmetic(), there, geometry::contact_slack);
  };
  for (int round = 0; round < rounds; ++round)
    make(round, 57);  // eight rows: sixteen rounds fill a window
  for (int round = 0; round < rounds; ++round)
    EXPECT_EQ(stays(round), round % window < 16) << round;
  rows.forget(3), rows.forget(4);
  EXPECT_TRUE(rows.missing(3));
  rows.forget(20), make(20, 64), rows.forget(21), make(21, 49);
  EXPECT_TRUE(stays(20) && stays(21));
  rows.forget(22), make(22, 8);  // one row is left
  EXPECT_TRUE(stays(22));
  rows.forget(23), make(23, 1);
  EXPECT_FALSE(stays(23));
  make(40, 65);  // more than a round may have
  EXPECT_FALSE(stays(40) || rows.missing(40));
  rows.forget();
  for (int round = 0; round < rounds; ++round)
    EXPECT_TRUE(rows.missing(round));
}

}  // namespace
}  // namespace blocks::dynamics
