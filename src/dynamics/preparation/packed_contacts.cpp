#include "dynamics/preparation/packed_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/search/near_pairs.hpp"
#include "model/safe_fraction.hpp"

namespace blocks::dynamics {
namespace {

/// Springs of unit stiffness, in all directions, at points of a block.
struct Springs {
  double count = 0.0;
  Vec2 arms = Vec2::Zero();  ///< [L] sum of the arms from the centroid
  double squares = 0.0;      ///< [L^2] sum of their squares

  void add(const Vec2& arm, double number) {
    count += number, arms += number * arm, squares += number * arm.squaredNorm();
  }
  /// Returns the square of the highest frequency of a block with this mass and moment
  /// of inertia, whose neighbours do not move, times its mass. It is the larger
  /// eigenvalue of [count h; h J]: rotation moves the centroid if the arms have a sum.
  double stiffness(double mass, double inertia) const {
    const double turning = squares * mass / inertia;
    const double coupling = arms.squaredNorm() * mass / inertia;
    return 0.5 * (count + turning) +
           std::sqrt(0.25 * (count - turning) * (count - turning) + coupling);
  }
};

/// Returns the point nearest to `point` on the side that begins at corner c.
Vec2 nearest_on_side(const Blocks& blocks, int c, const Vec2& point) {
  const Vec2 a = blocks.corner.col(c), along = blocks.corner.col(blocks.next[c]) - a;
  return a + std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

/// Counts the contacts of all blocks.
class Counter {
 public:
  Counter(const Blocks& blocks, double tolerance)
      : blocks_(blocks), square_(tolerance * tolerance),
        springs_(static_cast<std::size_t>(blocks.size())),
        near_corner_(static_cast<std::size_t>(blocks.corners())) {
    for (int c = 0; c < blocks.corners(); ++c)
      add(blocks.corner_block[static_cast<std::size_t>(c)], blocks.corner.col(c), 2.0);
  }
  /// Adds the corners of another block that are near the outline of block b.
  void add_corners(int b, int other) {
    if (!blocks_.is_free(b))
      return;
    for (int c = blocks_.first_corner[other]; c < blocks_.first_corner[other + 1]; ++c)
      add_if_near(b, blocks_.corner.col(c));
  }
  Eigen::VectorXd counts() const {
    constexpr double of_rectangle =
        3.0;  // stiffness() of one contact at each corner / 4
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(blocks_.size());
    for (int b = 0; b < blocks_.size(); ++b)
      if (blocks_.is_free(b))
        counts[b] = springs_[static_cast<std::size_t>(b)].stiffness(
                        blocks_.mass[b], blocks_.inertia[b]) /
                    of_rectangle;
    return counts;
  }

 private:
  void add(int b, const Vec2& point, double number) {
    springs_[static_cast<std::size_t>(b)].add(point - blocks_.centroid.col(b), number);
  }
  /// A contact is on the outline, however far from it the point is.
  void add_if_near(int b, const Vec2& point) {
    double min = square_;
    std::optional<Vec2> on_side;
    for (int c = blocks_.first_corner[b]; c < blocks_.first_corner[b + 1]; ++c) {
      const Vec2 corner = blocks_.corner.col(c);
      if ((corner - point).squaredNorm() <= square_) {
        if (near_corner_[static_cast<std::size_t>(c)]++ < 2)
          add(b, corner, 1.0);
        return;
      }
      const Vec2 nearest = nearest_on_side(blocks_, c, point);
      if (const double distance = (nearest - point).squaredNorm(); distance <= min)
        min = distance, on_side = nearest;
    }
    if (on_side)
      add(b, *on_side, 1.0);
  }

  const Blocks& blocks_;
  double square_;
  std::vector<Springs> springs_;  ///< (blocks)
  std::vector<int> near_corner_;  ///< (corners) corners of other blocks near it
};

}  // namespace

Eigen::VectorXd packed_contacts(const Blocks& blocks, double tolerance) {
  Counter counter(blocks, tolerance);
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(blocks, tolerance, memory, pairs);
  for (const auto& [low, high] : pairs)
    counter.add_corners(low, high), counter.add_corners(high, low);
  return counter.counts();
}

int touching_corners(const Blocks& blocks, int a, int b, double tolerance) {
  const auto near = [&](int block, const Vec2& point) {
    for (int c = blocks.first_corner[block]; c < blocks.first_corner[block + 1]; ++c)
      if ((nearest_on_side(blocks, c, point) - point).norm() <= tolerance)
        return true;
    return false;
  };
  int count = 0;
  for (const auto& [block, other] : {std::pair{a, b}, std::pair{b, a}})
    for (int c = blocks.first_corner[other]; c < blocks.first_corner[other + 1]; ++c)
      count += near(block, blocks.corner.col(c)) ? 1 : 0;
  return count;
}

Eigen::VectorXd contact_shares(const Model& model) {
  const Settings& settings = model.settings;
  const auto fraction = [&](double count) {
    return safe_fraction(settings.damping, settings.local_damping, count);
  };
  // More dashpots shorten the safe step more than more springs do.
  return packed_contacts(model.blocks, settings.contact_tolerance)
      .unaryExpr([&](double count) {
        const double times = fraction(usual_contacts) / fraction(count);
        return count > usual_contacts ? times * times : 1.0;
      });
}

}  // namespace blocks::dynamics
