// Joints that meet in points: notches, tips on joints and crossings of joints. Each
// deck of validation/robustness/points runs with an audit, and its worst overlap is at
// most the expected one.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

const fs::path points = fs::path(BLOCKS_SOURCE_DIR) / "validation/robustness/points";

/// A line of expected.csv. What is not given is negative.
struct Point {
  std::string deck;
  double ever = -1.0, end = -1.0;  ///< [mm] largest overlap in the run and at its end
  double momentum_x = -1.0;        ///< [M L/T] at the end, of what must go on sliding
  friend std::ostream& operator<<(std::ostream& out, const Point& one) {
    return out << one.deck;
  }
};

std::vector<Point> all_points() {
  std::ifstream file(points / "expected.csv");
  std::vector<Point> found;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string deck;
    std::getline(fields, deck, ',');
    const auto next = [&] {
      std::string text;
      std::getline(fields, text, ',');
      return text.empty() ? -1.0 : std::stod(text);
    };
    const double ever = next(), end = next();
    found.push_back({deck, ever, end, next()});
  }
  return found;
}

class PointOfJoints : public ::testing::TestWithParam<Point> {};

TEST_P(PointOfJoints, IsNotThere) {
  const Point& point = GetParam();
  const TemporaryFolder folder;
  const fs::path deck = points / (point.deck + ".deck");
  const Outcome run =
      blocks("run -q --audit '" + deck.string() + "' -o a", folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto made = summary(folder, "a");
  const auto overlap = made["worst_overlap"];
  if (point.ever >= 0.0) {
    EXPECT_LE(1e3 * overlap["ever"].get<double>(), point.ever);
  }
  if (point.end >= 0.0) {
    EXPECT_LE(1e3 * overlap["end"].get<double>(), point.end);
  }
  if (point.momentum_x >= 0.0) {
    EXPECT_NEAR(made["momentum"][0].get<double>(), point.momentum_x,
                0.002 * point.momentum_x);
  }
}

INSTANTIATE_TEST_SUITE_P(Points, PointOfJoints, ::testing::ValuesIn(all_points()),
                         [](const auto& one) { return one.param.deck; });

TEST(PointsOfJoints, AreAllExpected) {
  EXPECT_EQ(all_points().size(), decks_below(points.string()).size());
}

}  // namespace
}  // namespace blocks::testing
