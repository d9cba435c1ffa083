#include "dynamics/decisions/decisions.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The growth of MotionBounds::most before a pair can move by as much as this. While
/// `most` grows by d, a shift grows by at most d and a turn by at most 2 d (its norm is
/// at most twice that of a tensor), and no sum has more than four of either.
double growth_until(const PairMotion& left) {
  return std::max(0.0, std::min(0.25 * left.two, 0.125 * left.neighbours));
}

}  // namespace

void Decisions::forget(const Blocks& blocks, int pairs) {
  bounds.begin_phase(blocks);
  limits.assign(static_cast<std::size_t>(pairs), {});
  next_check.assign(static_cast<std::size_t>(pairs), 0.0);
}

PairMotion Decisions::motion_of(const Blocks& blocks, const PairIndex& index, int p,
                                bool neighbours) const {
  const auto [low, high] = index.pairs[p];
  const Vec2 low_shift = bounds.shift(blocks, low),
             high_shift = bounds.shift(blocks, high);
  const double turns = bounds.turn(blocks, low) + bounds.turn(blocks, high);
  const double two = 1.0000001 * (low_shift - high_shift).norm() + turns;
  double farthest = 0.0;
  const auto include = [&](int block, const Vec2& shift) {
    index.each_neighbour(block, [&](int other) {
      const double apart = (bounds.shift(blocks, other) - shift).lpNorm<1>();
      farthest = std::max(farthest, 1.0000001 * apart + bounds.turn(blocks, other));
    });
  };
  if (neighbours)
    include(low, low_shift), include(high, high_shift);
  return {two, two + farthest};
}

double Decisions::left_of(const Blocks& blocks, const PairIndex& index, int p) const {
  const bool neighbours = limits[p].neighbours < infinite;
  const PairMotion now = motion_of(blocks, index, p, neighbours);
  return growth_until({limits[p].two - now.two, limits[p].neighbours - now.neighbours});
}

void Decisions::keep(const Blocks& blocks, const PairIndex& index, int p,
                     const PairMotion& room) {
  // From now on, motion is at most the sum of that until now and that until then.
  const PairMotion now = motion_of(blocks, index, p, room.neighbours < infinite);
  limits[p] = {room.two - now.two, room.neighbours - now.neighbours};
  next_check[p] = bounds.most + growth_until({limits[p].two - now.two,
                                              limits[p].neighbours - now.neighbours});
}

void Decisions::renew_phase(const Blocks& blocks, const PairIndex& index) {
  if (!(bounds.most > bounds.phase_length))
    return;
  for (int p = 0; p < index.size(); ++p) {
    const PairMotion now = motion_of(blocks, index, p, limits[p].neighbours < infinite);
    PairMotion& limit = limits[p];
    limit.two -= now.two, limit.neighbours -= now.neighbours;
    next_check[p] = growth_until(limit);
  }
  bounds.begin_phase(blocks);
}

}  // namespace blocks::dynamics
