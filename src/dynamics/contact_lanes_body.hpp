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

typedef signed char Marks __attribute__((vector_size(width)));
BLOCKS_INLINE Marks load(const signed char* row, int first) {
  Marks marks;
  __builtin_memcpy(&marks, row + first, width);
  return marks;
}
BLOCKS_INLINE void store(signed char* row, int first, Marks marks) {
  __builtin_memcpy(row + first, &marks, width);
}
BLOCKS_INLINE Mask mask_of(Marks yes) { return __builtin_convertvector(yes, Mask); }
BLOCKS_INLINE bool any(Marks marks) {
  unsigned long long word = 0;
  __builtin_memcpy(&word, &marks, width);
  return word != 0;
}
BLOCKS_INLINE Marks marks_of(Mask yes) { return __builtin_convertvector(yes, Marks); }
BLOCKS_INLINE Set absolute(Set x) { return x < 0.0 ? -x : x; }
BLOCKS_INLINE Set root(Set x) {
  for (int k = 0; k < width; ++k)
    x[k] = __builtin_sqrt(x[k]);
  return x;
}

/// Corners against edges: 2A of (19), and filter::overlap of
/// geometry/contact_predicates.hpp.
struct Sides {
  Set xc, yc, ex, ey, cx, cy, plus, minus, value;

  BLOCKS_INLINE Sides(const SlotPlaces& slot, const BlockRows& blocks, int i) {
    const Point c = gather_point<2>(blocks.corner, slot.corner + i);
    const Point p1 = gather_point<2>(blocks.corner, slot.edge + i);
    const Point p2 = gather_point<2>(blocks.corner, slot.edge_end + i);
    xc = c.x, yc = c.y;
    ex = p2.x - p1.x, ey = p2.y - p1.y;
    cx = xc - p1.x, cy = yc - p1.y;
    plus = cx * ey, minus = cy * ex;
    value = plus - minus;
  }
  BLOCKS_INLINE Set bound() const {
    return 0x1p-51 * (absolute(plus) + absolute(minus)) + 0x1p-1000;
  }
  /// 2A is 0, for a factor of either product is: of bricks that touch as they were
  /// made.
  BLOCKS_INLINE Mask tie() const {
    return ((cx == 0.0) | (ey == 0.0)) & ((cy == 0.0) | (ex == 0.0));
  }
};

/// Which lanes touch. A sign in doubt is taken to, until it is looked at: adds to
/// `look` whose sign is in doubt, or who does not touch any more.
BLOCKS_INLINE Marks find_touching(SlotPlaces& slot, const Sides& sides, int i,
                                  Marks& look) {
  const Set bound = sides.bound();
  const Marks rule = load(slot.rule, i), before = load(slot.touch, i);
  const Marks asked = rule == by_sign;
  Marks inside = ~marks_of(sides.value < -bound);
  Marks open = asked & inside & ~marks_of(sides.value > bound);
  if (any(open)) {
    const Marks tie = marks_of(sides.tie());
    inside &= ~tie, open &= ~tie;
  }
  const Marks acts = (rule == decided) | (asked & inside);
  const Marks touch =
      acts & ((before != apart) ? in_touch + Marks{} : starting + Marks{});
  store(slot.touch, i, touch);
  look |= open | ((touch == apart) & (before != apart));
  return touch;
}

/// Two blocks of each lane: where they are, and how the high one sees the low one move.
template <bool rigid> struct Pairs {
  Set low_x, low_y, high_x, high_y;  ///< centroids
  Set vx, vy;                        ///< relative velocity at the low one
  Set g11, g12, g21, g22;  ///< how it changes with the place; rigid: g21 = -g12 only

  BLOCKS_INLINE Pairs(const LanePairs& pairs, const BlockRows& blocks, int i) {
    const int *const a = pairs.low + i, *const b = pairs.high + i;
    const Point low = gather_point<2>(blocks.centroid, a);
    const Point high = gather_point<2>(blocks.centroid, b);
    const Point va = gather_point<2>(blocks.velocity, a);
    const Point vb = gather_point<2>(blocks.velocity, b);
    const Set spin_a = gather(blocks.spin, a), spin_b = gather(blocks.spin, b);
    low_x = low.x, low_y = low.y, high_x = high.x, high_y = high.y;
    const Set x = low.x - high.x, y = low.y - high.y;
    vx = va.x - (vb.x - spin_b * y), vy = va.y - (vb.y + spin_b * x);
    g21 = spin_a - spin_b, g12 = -g21;
    if constexpr (!rigid) {
      const double* const rate = blocks.strain_rate;
      const Point a1 = gather_point<4>(rate, a, 0), a2 = gather_point<4>(rate, a, 2);
      const Point b1 = gather_point<4>(rate, b, 0), b2 = gather_point<4>(rate, b, 2);
      vx -= b1.x * x + b1.y * y, vy -= b2.x * x + b2.y * y;
      g11 = a1.x - b1.x, g12 += a1.y - b1.y;
      g21 += a2.x - b2.x, g22 = a2.y - b2.y;
    }
  }
  /// Relative velocity (14) at an arm from the low block's centroid.
  BLOCKS_INLINE Point velocity(Set x, Set y) const {
    if constexpr (rigid)
      return {vx + g12 * y, vy + g21 * x};
    else
      return {vx + (g11 * x + g12 * y), vy + (g21 * x + g22 * y)};
  }
};

/// Deepest overlap and strongest spring, lane by lane.
struct Most {
  Set overlap = {}, spring = {};
  BLOCKS_INLINE void include(Set depth, Set force) {
    overlap = depth > overlap ? depth : overlap;
    spring = force > spring ? force : spring;
  }
};

/// Adds to `look` as find_touching does; find: false: what touches is known.
template <bool find, bool rigid, bool readings>
BLOCKS_INLINE Most act_set(const LaneSets& sets, int set, const BlockRows& blocks,
                           const ContactLaw& law, int i, Marks& look) {
  constexpr bool stresses = readings || !rigid;
  const LanePairs& pairs = sets.pairs[set];
  const Pairs<rigid> two(pairs, blocks, i);
  const Set none = all_of(0.0), damping = load(pairs.damping, i);
  Set sum_x = none, sum_y = none, moment_low = none, moment_high = none;
  Set low[4] = {}, high[4] = {};
  Most most;
  for (int s = pairs.first_slot; s < pairs.first_slot + pairs.slots; ++s) {
    // a. frame of the edge, overlap: its sign is decided exactly; rounded, a tiny depth
    // may come out below zero
    SlotPlaces& slot = sets.places[s];
    const SlotSprings& springs = sets.springs[s];
    const Sides sides(slot, blocks, i);
    const Marks touch =
        find ? find_touching(slot, sides, i, look) : load(slot.touch, i);
    const Set per_length = 1.0 / root(sides.ex * sides.ex + sides.ey * sides.ey);
    const Set depth = sides.value * per_length, overlap = depth > 0.0 ? depth : none;
    // tangent and normal, turned where the force on the low block is that on the edge
    const Set turned = mask_of(load(slot.flip, i) != 0) ? -per_length : per_length;
    const Set tx = sides.ex * turned, ty = sides.ey * turned, nx = -ty, ny = tx;
    const Set x = sides.xc - two.low_x, y = sides.yc - two.low_y;
    const auto [vx, vy] = two.velocity(x, y);

    // b.-d.
    const Mask acts = mask_of(touch != apart);
    const Marks starts = touch == starting;
    Set normal_elastic = load(springs.normal_elastic, i);
    Set shear_elastic = load(springs.shear_elastic, i);
    Set normal, shear;
    const Set closing = -(vx * nx + vy * ny), sliding = vx * tx + vy * ty;
    if (any(starts))
      apply(law, normal_elastic, shear_elastic, closing, sliding, overlap, damping,
            mask_of(starts) ? all_of(1.0) : none, normal, shear);
    else
      apply<false>(law, normal_elastic, shear_elastic, closing, sliding, overlap,
                   damping, none, normal, shear);
    normal_elastic = acts ? normal_elastic : none;
    SlotSprings& advanced = sets.advanced[s];
    store(advanced.normal_elastic, i, normal_elastic);
    store(advanced.shear_elastic, i, acts ? shear_elastic : none);
    const Set reached = acts ? overlap : none;
    most.include(reached, normal_elastic);

    // e. equal and opposite at one point
    const Set fx = acts ? normal * nx - shear * tx : none;
    const Set fy = acts ? normal * ny - shear * ty : none;
    const Set high_x = sides.xc - two.high_x, high_y = sides.yc - two.high_y;
    sum_x += fx, sum_y += fy;
    moment_low += x * fy - y * fx, moment_high += high_y * fx - high_x * fy;
    if constexpr (stresses) {
      low[0] += fx * x, high[0] -= fx * high_x;
      low[1] += fx * y, high[1] -= fx * high_y;
      low[2] += fy * x, high[2] -= fy * high_x;
      low[3] += fy * y, high[3] -= fy * high_y;
    }
    if constexpr (readings) {
      SlotReadings& read = sets.readings[s - sets.first_reading];
      store(read.overlap, i, reached);
      store(read.normal_force, i, acts ? normal : none);
      store(read.shear_force, i, acts ? shear : none);
    }
  }
  PairForces& forces = sets.forces[set];
  store(forces.fx, i, sum_x);
  store(forces.fy, i, sum_y);
  store(forces.moment_low, i, moment_low);
  store(forces.moment_high, i, moment_high);
  if constexpr (stresses) {
    PairStresses& sums = sets.stresses[set - sets.first_stress];
    for (int k = 0; k < 4; ++k)
      store(sums.low[k], i, low[k]), store(sums.high[k], i, high[k]);
  }
  return most;
}

template <bool find, bool rigid, bool readings>
LaneExtremes act_sets(const LaneSets& sets, const BlockRows& blocks,
                      const ContactLaw& law, int first, int last) {
  Most all;
  for (int set = first; set < last; ++set) {
    Marks look = {};
    Most most;
    for (int i = 0; i < lane_count; i += width) {
      const Most part = act_set<find, rigid, readings>(sets, set, blocks, law, i, look);
      most.include(part.overlap, part.spring);
    }
    if constexpr (find)
      sets.pairs[set].look = any(look);
    if (!any(look))
      all.include(most.overlap, most.spring);
  }
  LaneExtremes extremes = {0.0, 0.0};
  for (int k = 0; k < width; ++k) {
    extremes.overlap =
        all.overlap[k] > extremes.overlap ? all.overlap[k] : extremes.overlap;
    extremes.spring = all.spring[k] > extremes.spring ? all.spring[k] : extremes.spring;
  }
  return extremes;
}

}  // namespace

LaneExtremes touch_and_act(const LaneSets& sets, const BlockRows& blocks,
                           const ContactLaw& law, bool rigid, int first, int last) {
  const auto all = rigid ? act_sets<true, true, false> : act_sets<true, false, false>;
  return all(sets, blocks, law, first, last);
}

LaneExtremes act(const LaneSets& sets, const BlockRows& blocks, const ContactLaw& law,
                 bool rigid, bool readings, int first, int last) {
  const auto all =
      rigid      ? readings ? act_sets<false, true, true> : act_sets<false, true, false>
           : readings ? act_sets<false, false, true>
                 : act_sets<false, false, false>;
  return all(sets, blocks, law, first, last);
}

}  // namespace blocks::dynamics::BLOCKS_LANES
