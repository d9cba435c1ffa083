#include "dynamics/decisions/decisions.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns by how much MotionBounds::most may grow before the motion of a pair can grow
/// by `left`. While `most` grows by d, shift and turn of one block together grow by at
/// most 2 d. The reason is that `turn` is at most four times the motion of an arm,
/// which `most` counts twice. So the motion of two blocks grows by at most 4 d. The
/// motion of a neighbour against one of them adds at most 4 d.
double growth_until(const PairMotion& left) {
  return std::max(0.0, std::min(0.25 * left.two, 0.125 * left.neighbours));
}

}  // namespace

void Decisions::begin_phase(const Blocks& blocks) {
  bounds.begin_phase(blocks);
  spoiled = 0;
}

void Decisions::reset(const Blocks& blocks, int pairs) {
  begin_phase(blocks);
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
    index.neighbours.each(block, [&](int other) {
      const double apart = (bounds.shift(blocks, other) - shift).lpNorm<1>();
      farthest = std::max(farthest, 1.0000001 * apart + bounds.turn(blocks, other));
    });
  };
  if (neighbours)
    include(low, low_shift), include(high, high_shift);
  return {two, two + farthest};
}

double Decisions::growth_left(const Blocks& blocks, const PairIndex& index,
                              int p) const {
  const bool neighbours = limits[p].neighbours < infinite;
  const PairMotion now = motion_of(blocks, index, p, neighbours);
  return growth_until({limits[p].two - now.two, limits[p].neighbours - now.neighbours});
}

bool Decisions::keep(const Blocks& blocks, const PairIndex& index, int p,
                     const PairMotion& room) {
  // A motion from now on is at most the sum of the motions of the phase until now and
  // until then. So the limits are the rooms less the motions until now.
  const PairMotion now = motion_of(blocks, index, p, room.neighbours < infinite);
  limits[p] = {room.two - now.two, room.neighbours - now.neighbours};
  next_check[p] = bounds.most + growth_until({limits[p].two - now.two,
                                              limits[p].neighbours - now.neighbours});
  return limits[p].two < 0.5 * room.two || limits[p].neighbours < 0.5 * room.neighbours;
}

void Decisions::carry_over(const Blocks& blocks, const PairIndex& index, int begin,
                           int end) {
  for (int p = begin; p < end; ++p) {
    PairMotion& limit = limits[p];
    const PairMotion now = motion_of(blocks, index, p, limit.neighbours < infinite);
    limit.two -= now.two, limit.neighbours -= now.neighbours;
    next_check[p] = growth_until(limit);
  }
}

}  // namespace blocks::dynamics
