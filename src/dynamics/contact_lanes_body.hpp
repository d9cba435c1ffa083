// The computations of contact_lanes.hpp. Included once for each instruction set, in a
// namespace of its own; calls nothing that is not compiled here. A Set is as many
// numbers as one register holds, one of each lane, and its operators act lane by lane.
#include <cstddef>
#include <utility>

#include "dynamics/contact_lanes.hpp"

namespace blocks::dynamics::BLOCKS_LANES {
namespace {

constexpr int width = BLOCKS_LANES_AT_ONCE;
typedef double Set __attribute__((vector_size(width * sizeof(double))));
using Mask = decltype(Set{} < Set{});
#define BLOCKS_INLINE [[gnu::always_inline]] inline

BLOCKS_INLINE Set all_of(double x) { return Set{} + x; }
BLOCKS_INLINE Set load(const double* row, int first) {
  return *reinterpret_cast<const Set*>(row + first);
}
BLOCKS_INLINE void store(double* row, int first, Set x) {
  *reinterpret_cast<Set*>(row + first) = x;
}
/// One number for each lane.
template <std::size_t... lane>
BLOCKS_INLINE Set gather(const double* row, const int* index,
                         std::index_sequence<lane...>) {
  return Set{row[index[lane]]...};
}
BLOCKS_INLINE Set gather(const double* row, const int* index) {
  return gather(row, index, std::make_index_sequence<width>());
}

struct Point {
  Set x, y;
};
typedef double Pair __attribute__((vector_size(2 * sizeof(double))));
/// Two numbers for each lane: rows r and r + 1 of column `index` of a matrix.
template <int rows, int at_once = width>
BLOCKS_INLINE Point gather_point(const double* matrix, const int* index, int r = 0) {
  const auto at = [&](int k) __attribute__((always_inline)) {
    const double* const p = matrix + static_cast<std::ptrdiff_t>(rows) * index[k] + r;
    return Pair{p[0], p[1]};
  };
  if constexpr (at_once == 2) {
    return {__builtin_shufflevector(at(0), at(1), 0, 2),
            __builtin_shufflevector(at(0), at(1), 1, 3)};
  } else {
    const auto two = [&](int k) __attribute__((always_inline)) {
      return __builtin_shufflevector(at(k), at(k + 1), 0, 1, 2, 3);
    };
    if constexpr (at_once == 4) {
      return {__builtin_shufflevector(two(0), two(2), 0, 2, 4, 6),
              __builtin_shufflevector(two(0), two(2), 1, 3, 5, 7)};
    } else {
      const auto four = [&](int k) __attribute__((always_inline)) {
        return __builtin_shufflevector(two(k), two(k + 2), 0, 1, 2, 3, 4, 5, 6, 7);
      };
      const auto p = four(0), q = four(4);
      return {__builtin_shufflevector(p, q, 0, 2, 4, 6, 8, 10, 12, 14),
              __builtin_shufflevector(p, q, 1, 3, 5, 7, 9, 11, 13, 15)};
    }
  }
}

template <std::size_t... lane>
BLOCKS_INLINE bool any(Mask mask, std::index_sequence<lane...>) {
  return (mask[lane] | ...) != 0;
}
typedef int Integers __attribute__((vector_size(width * sizeof(int))));
BLOCKS_INLINE Mask all_less(const int* a, const int* b) {
  const Integers less =
      *reinterpret_cast<const Integers*>(a) < *reinterpret_cast<const Integers*>(b);
  return __builtin_convertvector(less, Mask);
}
BLOCKS_INLINE Set absolute(Set x) { return x < 0.0 ? -x : x; }
BLOCKS_INLINE Set root(Set x) {
  for (int k = 0; k < width; ++k)
    x[k] = __builtin_sqrt(x[k]);
  return x;
}

/// Corners against edges: 2A of (19), and filter::overlap of
/// geometry/contact_predicates.hpp.
struct Sides {
  Set xc, yc, ex, ey, value, bound;

  BLOCKS_INLINE Sides(const LanePlaces& l, const BlockRows& blocks, int i) {
    const Point c = gather_point<2>(blocks.corner, l.corner + i);
    const Point p1 = gather_point<2>(blocks.corner, l.edge + i);
    const Point p2 = gather_point<2>(blocks.corner, l.edge_end + i);
    xc = c.x, yc = c.y;
    ex = p2.x - p1.x, ey = p2.y - p1.y;
    const Set plus = (xc - p1.x) * ey, minus = (yc - p1.y) * ex;
    value = plus - minus;
    bound = 0x1p-51 * (absolute(plus) + absolute(minus)) + 0x1p-1000;
  }
};

/// A sign in doubt is taken to touch, until it is looked at.
BLOCKS_INLINE void find_touching_set(LanePlaces& l, const BlockRows& blocks, int i) {
  const Sides sides(l, blocks, i);
  const Set rule = load(l.rule, i), before = load(l.touch, i);
  const Mask asked = rule == by_sign, outside = sides.value < -sides.bound;
  const Mask clear = outside | (sides.value > sides.bound);
  const Set if_inside = before > 0.0 ? all_of(in_touch) : all_of(starting);
  const Set if_asked = outside ? all_of(apart) : if_inside;
  const Set if_not = rule == decided ? if_inside : all_of(apart);
  const Set touch = asked ? if_asked : if_not;
  store(l.touch, i, touch);
  const Mask lost = (touch == apart) & (before > 0.0);
  if (any((asked & ~clear) | lost, std::make_index_sequence<width>()))
    l.look = 1;
}

template <bool rigid>
BLOCKS_INLINE void act_set(const LaneSets& sets, int set, const BlockRows& blocks,
                           const ContactLaw& law, int i, Set& deepest, Set& strongest) {
  // a. frame of the edge, overlap: its sign is decided exactly; rounded, a tiny depth
  // may come out below zero
  const LanePlaces& l = sets.places[set];
  LaneSprings& springs = sets.springs[set];
  LaneForces& forces = sets.forces[set];
  LaneReadings& readings = sets.readings[set];
  const Sides sides(l, blocks, i);
  const Set none = all_of(0.0);
  const Set per_length = 1.0 / root(sides.ex * sides.ex + sides.ey * sides.ey);
  const Set depth = sides.value * per_length, overlap = depth > 0.0 ? depth : none;
  const Set tx = sides.ex * per_length, ty = sides.ey * per_length, nx = -ty, ny = tx;

  // relative velocity of the two material points (14)
  const int *const a = l.corner_block + i, *const b = l.edge_block + i;
  const auto [ax, ay] = gather_point<2>(blocks.arm, l.corner + i);
  const Point centroid = gather_point<2>(blocks.centroid, b);
  const Set bx = sides.xc - centroid.x, by = sides.yc - centroid.y;
  const Set spin_a = gather(blocks.spin, a), spin_b = gather(blocks.spin, b);
  Point va = gather_point<2>(blocks.velocity, a);
  Point vb = gather_point<2>(blocks.velocity, b);
  va.x -= spin_a * ay, va.y += spin_a * ax;
  vb.x -= spin_b * by, vb.y += spin_b * bx;
  if constexpr (!rigid) {
    const double* const rate = blocks.strain_rate;
    const Point a1 = gather_point<4>(rate, a, 0), a2 = gather_point<4>(rate, a, 2);
    const Point b1 = gather_point<4>(rate, b, 0), b2 = gather_point<4>(rate, b, 2);
    va.x += a1.x * ax + a1.y * ay, va.y += a2.x * ax + a2.y * ay;
    vb.x += b1.x * bx + b1.y * by, vb.y += b2.x * bx + b2.y * by;
  }
  const Set vx = va.x - vb.x, vy = va.y - vb.y;

  // b.-d.
  const Set touch = load(l.touch, i);
  const Mask acts = touch > 0.0;
  Set normal_elastic = load(springs.normal_elastic, i);
  Set shear_elastic = load(springs.shear_elastic, i);
  Set normal, shear;
  apply(law, normal_elastic, shear_elastic, -(vx * nx + vy * ny), vx * tx + vy * ty,
        overlap, load(springs.damping, i), touch - 1.0, normal, shear);
  normal_elastic = acts ? normal_elastic : none;
  normal = acts ? normal : none;
  shear = acts ? shear : none;
  store(springs.normal_elastic, i, normal_elastic);
  store(springs.shear_elastic, i, acts ? shear_elastic : none);
  const Set reached = acts ? overlap : none;
  deepest = reached > deepest ? reached : deepest;
  strongest = normal_elastic > strongest ? normal_elastic : strongest;

  // e. equal and opposite at one point
  const Set fx = normal * nx - shear * tx, fy = normal * ny - shear * ty;
  const Set moment_a = ax * fy - ay * fx, moment_b = by * fx - bx * fy;
  const Mask low = all_less(a, b);
  store(forces.fx, i, low ? fx : -fx);
  store(forces.fy, i, low ? fy : -fy);
  store(forces.moment_low, i, low ? moment_a : moment_b);
  store(forces.moment_high, i, low ? moment_b : moment_a);
  store(readings.low_x, i, low ? ax : bx);
  store(readings.low_y, i, low ? ay : by);
  store(readings.high_x, i, low ? bx : ax);
  store(readings.high_y, i, low ? by : ay);
  store(readings.overlap, i, reached);
  store(readings.normal_force, i, normal);
  store(readings.shear_force, i, shear);
}

template <bool rigid>
LaneExtremes act_sets(const LaneSets& sets, const BlockRows& blocks,
                      const ContactLaw& law, int first, int last) {
  Set deepest = all_of(0.0), strongest = all_of(0.0);
  for (int set = first; set < last; ++set)
    for (int i = 0; i < lane_count; i += width)
      act_set<rigid>(sets, set, blocks, law, i, deepest, strongest);
  LaneExtremes extremes = {0.0, 0.0};
  for (int k = 0; k < width; ++k) {
    extremes.overlap = deepest[k] > extremes.overlap ? deepest[k] : extremes.overlap;
    extremes.spring = strongest[k] > extremes.spring ? strongest[k] : extremes.spring;
  }
  return extremes;
}

}  // namespace

void find_touching(const LaneSets& sets, const BlockRows& blocks, int first, int last) {
  for (int set = first; set < last; ++set) {
    sets.places[set].look = 0;
    for (int i = 0; i < lane_count; i += width)
      find_touching_set(sets.places[set], blocks, i);
  }
}

LaneExtremes act(const LaneSets& sets, const BlockRows& blocks, const ContactLaw& law,
                 bool rigid, int first, int last) {
  return rigid ? act_sets<true>(sets, blocks, law, first, last)
               : act_sets<false>(sets, blocks, law, first, last);
}

}  // namespace blocks::dynamics::BLOCKS_LANES
