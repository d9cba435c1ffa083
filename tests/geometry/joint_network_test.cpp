#include "geometry/joint_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace blocks::geometry {
namespace {

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x, y + height}, {x + width, y + height}, {x + width, y}};
}

/// A square of unit cells. Each cell belongs to one rectangular block.
class Lattice {
 public:
  Lattice(int size, std::mt19937& random)
      : size_(size), owner_(static_cast<std::size_t>(size * size), 0) {
    split(0, 0, size, size, random);
  }
  const std::vector<Polygon>& blocks() const { return blocks_; }

  /// The joints and vertices, counted from the owners of the cells alone.
  JointNetwork count() const {
    JointNetwork network;
    for (int i = 1; i < size_; ++i)
      for (int j = 0; j < size_; ++j) {
        network.length += owner(i - 1, j) != owner(i, j) ? 1.0 : 0.0;
        network.length += owner(j, i - 1) != owner(j, i) ? 1.0 : 0.0;
      }
    for (int i = 1; i < size_; ++i)
      for (int j = 1; j < size_; ++j) {
        const std::array around = {owner(i - 1, j - 1), owner(i, j - 1), owner(i, j),
                                   owner(i - 1, j)};
        int joints = 0;
        for (std::size_t k = 0; k < 4; ++k)
          joints += around[k] != around[(k + 1) % 4] ? 1 : 0;
        network.t_vertices += joints == 3 ? 1 : 0;
        network.x_vertices += joints == 4 ? 1 : 0;
      }
    return network;
  }

 private:
  int owner(int i, int j) const {
    return owner_[static_cast<std::size_t>(i * size_ + j)];
  }
  void split(int x, int y, int width, int height, std::mt19937& random) {
    const auto draw = [&](int low, int high) {
      return std::uniform_int_distribution<int>(low, high)(random);
    };
    if (width * height > 1 && (width * height > 12 || draw(0, 2) > 0)) {
      if (width > height || (width == height && draw(0, 1) == 0)) {
        const int left = draw(1, width - 1);
        split(x, y, left, height, random);
        split(x + left, y, width - left, height, random);
      } else {
        const int lower = draw(1, height - 1);
        split(x, y, width, lower, random);
        split(x, y + lower, width, height - lower, random);
      }
      return;
    }
    for (int i = x; i < x + width; ++i)
      for (int j = y; j < y + height; ++j)
        owner_[static_cast<std::size_t>(i * size_ + j)] =
            static_cast<int>(blocks_.size());
    blocks_.push_back(rectangle(x, y, width, height));
  }

  int size_;
  std::vector<int> owner_;
  std::vector<Polygon> blocks_;
};

void expect_counts(const JointNetwork& found, const JointNetwork& expected) {
  EXPECT_NEAR(found.length, expected.length, 1e-13 * expected.length);
  EXPECT_EQ(found.t_vertices, expected.t_vertices);
  EXPECT_EQ(found.x_vertices, expected.x_vertices);
}

// The cells know nothing of corners and edges, so this count is independent.
TEST(JointNetwork, AgreesWithTheCellsOfALattice) {
  std::mt19937 random(7);
  int t_vertices = 0, x_vertices = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const Lattice lattice(16, random);
    const JointNetwork expected = lattice.count();
    expect_counts(find_joint_network(lattice.blocks()), expected);
    t_vertices += expected.t_vertices;
    x_vertices += expected.x_vertices;
  }
  EXPECT_GT(t_vertices, 1000);
  EXPECT_GT(x_vertices, 100);
}

// After a turn, corners lie on edges and on each other only up to rounding.
TEST(JointNetwork, IsTheSameForTurnedBlocksInAnyOrder) {
  std::mt19937 random(8);
  for (int scene = 0; scene < 20; ++scene) {
    const Lattice lattice(12, random);
    std::vector<Polygon> turned = lattice.blocks();
    const double angle = 0.1 + scene;
    for (Polygon& block : turned)
      for (Vec2& p : block)
        p = Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y() + 100.0,
                 std::sin(angle) * p.x() + std::cos(angle) * p.y());
    expect_counts(find_joint_network(turned), lattice.count());
    std::shuffle(turned.begin(), turned.end(), random);
    expect_counts(find_joint_network(turned), lattice.count());
  }
}

TEST(JointNetwork, ATipOnAFloorIsATVertexWithoutAJoint) {
  const Polygon floor = rectangle(0, -1, 4, 1), tip = {{2, 0}, {1, 2}, {3, 2}};
  const JointNetwork network = find_joint_network({floor, tip});
  EXPECT_EQ(network.length, 0.0);
  EXPECT_EQ(network.t_vertices, 1);
  EXPECT_EQ(network.x_vertices, 0);
}

// A joint of two blocks ends at two vertices of two corners each, which do not count.
TEST(JointNetwork, CountsAJointOnceAndOnlyWhereBlocksTouch) {
  const Polygon left = rectangle(0, 0, 1, 3), right = rectangle(1, 0, 1, 3);
  expect_counts(find_joint_network({left, right}), {3.0, 0, 0});
  expect_counts(find_joint_network({left, {}, rectangle(1 + 1e-9, 0, 1, 3)}),
                {0.0, 0, 0});
}

// Six triangles around a point meet there with six corners.
TEST(JointNetwork, SixTrianglesMeetAtOneXVertex) {
  std::vector<Polygon> triangles;
  for (int i = 0; i < 6; ++i) {
    const auto corner = [](int k) {
      return Vec2(std::cos(M_PI / 3.0 * k), std::sin(M_PI / 3.0 * k));
    };
    triangles.push_back({Vec2::Zero(), corner(i + 1), corner(i)});
  }
  expect_counts(find_joint_network(triangles), {6.0, 0, 1});
}

}  // namespace
}  // namespace blocks::geometry
