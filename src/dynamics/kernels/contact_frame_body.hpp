// The geometry and the motion of contacts for the kernels of contact forces. Included
// once for each instruction set, in a namespace of its own.
#include "dynamics/kernels/contact_batch.hpp"
#include "dynamics/kernels/simd_lanes.hpp"
#include "geometry/contact_constants.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Corners and edges in each lane, with the values that decide whether a contact acts
/// (filter::overlap and filter::between of geometry/contact_predicates.hpp).
struct Sides {
  Pack xc, yc, ex, ey, cx, cy, plus, minus, value, square;

  BLOCKS_INLINE Sides() = default;
  BLOCKS_INLINE Sides(const ContactRow& contacts, const BlockState& blocks, int i) {
    const Point c = gather_point<2>(blocks.corner, contacts.corner + i);
    const Point p1 = gather_point<2>(blocks.corner, contacts.edge + i);
    const Point p2 = gather_point<2>(blocks.corner, contacts.edge_end + i);
    xc = c[0], yc = c[1];
    ex = p2[0] - p1[0], ey = p2[1] - p1[1];
    cx = xc - p1[0], cy = yc - p1[1];
    plus = cx * ey, minus = cy * ex;
    value = plus - minus;
    square = ex * ex + ey * ey;
  }
  /// Returns how far the foot of the corner is from the nearer limit of the edge, slack
  /// included, [L^2]. It is positive between the limits. `bound` gets the bound of its
  /// error.
  BLOCKS_INLINE Pack between(Pack& bound) const {
    const Pack x = cx * ex, y = cy * ey, foot = x + y,
               slack = geometry::contact_slack * square;
    bound = 0x1p-50 * ((absolute(x) + absolute(y)) + square) + 0x1p-1000;
    const Pack from = foot + slack, to = (square - foot) + slack;
    return from < to ? from : to;
  }
  BLOCKS_INLINE Pack bound() const {
    return 0x1p-51 * (absolute(plus) + absolute(minus)) + 0x1p-1000;
  }
  /// Returns the lanes where 2A is exactly 0 because both products have a factor 0.
  /// This happens between bricks that touch in their initial positions.
  BLOCKS_INLINE Bits tie() const {
    return (zero(cx) | zero(ey)) & (zero(cy) | zero(ex));
  }
};

/// Loads and stores the bits of one pack, which begins with lane i.
BLOCKS_INLINE Bits load(LaneBits bits, int i) { return bits >> i & every; }
BLOCKS_INLINE void store(LaneBits& bits, int i, Bits part) {
  bits = static_cast<LaneBits>((bits & ~(every << i)) | part << i);
}

/// Stores which lanes act. A lane with a sign in doubt is taken to act, and its bit
/// in_doubt is set.
BLOCKS_INLINE void find_acting(const ContactTests& tests, ContactStates& states,
                               const Sides& sides, int i) {
  const Pack bound = sides.bound();
  const Bits tested = load(tests.tested, i), before = load(states.acts, i);
  Bits inside = ~less(sides.value, -bound);
  Bits open = tested & inside & ~less(bound, sides.value);
  if (open != 0) {
    const Bits tie = sides.tie();
    inside &= ~tie, open &= ~tie;
  }
  Pack error;
  const Pack between = sides.between(error);
  inside &= ~less(between, -error);
  open &= inside;
  open |= tested & inside & ~less(error, between);
  const Bits act = load(tests.certain, i) | (tested & inside);
  store(states.acts, i, act);
  store(states.starts, i, act & ~before);
  store(states.ends, i, before & ~act);
  store(states.in_doubt, i, open);
}

/// The two blocks of each lane: their centroids, and the motion of the low block
/// relative to the high one.
template <bool rigid> struct Pairs {
  Pack low_x = {}, low_y = {}, high_x = {}, high_y = {};  ///< centroids
  Pack vx = {}, vy = {};  ///< relative velocity at the centroid of the low block
  Pack g11 = {}, g12 = {}, g21 = {}, g22 = {};  ///< gradient of the relative velocity

  BLOCKS_INLINE Pairs() = default;
  /// Velocities are those of half a step before the positions
  /// (docs/theory.md#the-velocities-of-a-contact). The arms were turned back then: the
  /// velocity at an arm r is v + w x (r - w x r dt/2). Since then the blocks have
  /// turned by half a step, and the relative velocity with them. dt = 0: none of this.
  BLOCKS_INLINE Pairs(const BatchPairs& pairs, const BlockState& blocks, double dt,
                      int i) {
    const int *const a = pairs.low + i, *const b = pairs.high + i;
    const Point low = gather_point<2>(blocks.centroid, a);
    const Point high = gather_point<2>(blocks.centroid, b);
    const Point va = gather_point<2>(blocks.velocity, a);
    const Point vb = gather_point<2>(blocks.velocity, b);
    const Pack spin_a = gather(blocks.spin, a), spin_b = gather(blocks.spin, b);
    low_x = low[0], low_y = low[1], high_x = high[0], high_y = high[1];
    const Pack x = low_x - high_x, y = low_y - high_y;
    const Pack inwards_a = 0.5 * dt * (spin_a * spin_a);
    const Pack inwards_b = 0.5 * dt * (spin_b * spin_b);
    vx = va[0] - (vb[0] - spin_b * y + inwards_b * x);
    vy = va[1] - (vb[1] + spin_b * x + inwards_b * y);
    g11 = g22 = inwards_a - inwards_b;
    g21 = spin_a - spin_b, g12 = -g21;
    if constexpr (!rigid) {
      const double* const rate = blocks.strain_rate;
      const Point a1 = gather_point<4>(rate, a, 0), a2 = gather_point<4>(rate, a, 2);
      const Point b1 = gather_point<4>(rate, b, 0), b2 = gather_point<4>(rate, b, 2);
      vx -= b1[0] * x + b1[1] * y, vy -= b2[0] * x + b2[1] * y;
      g11 += a1[0] - b1[0], g12 += a1[1] - b1[1];
      g21 += a2[0] - b2[0], g22 += a2[1] - b2[1];
    }
    turn(0.25 * dt * (spin_a + spin_b));
  }
  /// Returns the relative velocity (14) at an arm from the low block's centroid.
  BLOCKS_INLINE Point velocity(Pack x, Pack y) const {
    return {vx + (g11 * x + g12 * y), vy + (g21 * x + g22 * y)};
  }

 private:
  /// Turns the relative velocity by a small angle.
  BLOCKS_INLINE void turn(Pack angle) {
    const auto turn = [&](Pack & x, Pack & y) __attribute__((always_inline)) {
      const Pack x_before = x;
      x -= angle * y, y += angle * x_before;
    };
    turn(vx, vy), turn(g11, g21), turn(g12, g22);
  }
};

/// The deepest overlap and the strongest spring of each lane.
struct Maxima {
  Pack overlap = {}, spring = {};
  BLOCKS_INLINE void include(Pack depth, Pack force) {
    overlap = depth > overlap ? depth : overlap;
    spring = force > spring ? force : spring;
  }
};

/// a. The geometry of a contact: its corner, the directions of its edge, its overlap.
struct Frame {
  Pack x, y;  ///< the corner
  /// Unit tangent of the edge. It is reversed if the edge belongs to the low block, so
  /// that the computed force acts on the low block.
  Pack tx, ty;
  /// [L] The sign of the depth is decided exactly. A rounded depth below zero counts as
  /// 0.
  Pack overlap;
  Pack per_length;  ///< [1/L] of the edge
};

/// Computes the frame of a row.
BLOCKS_INLINE Frame frame_of(const Sides& sides, const ContactTests& tests, int i) {
  const Pack per_length = 1.0 / root(sides.square);
  const Pack depth = sides.value * per_length;
  const Pack turned =
      where(choice_of(load(tests.edge_is_low, i)), -per_length, per_length);
  return {sides.xc,
          sides.yc,
          sides.ex * turned,
          sides.ey * turned,
          depth > 0.0 ? depth : Pack{},
          per_length};
}

/// The forces of a pair, summed row by row.
template <bool stresses> struct Sums {
  Pack x = {}, y = {}, moment_low = {}, moment_high = {};
  Pack low[stresses ? 4 : 1] = {}, high[stresses ? 4 : 1] = {};

  /// Adds a force on the low block. The arms begin at the two centroids.
  BLOCKS_INLINE void add(Pack fx, Pack fy, Pack low_x, Pack low_y, Pack high_x,
                         Pack high_y) {
    x += fx, y += fy;
    moment_low += low_x * fy - low_y * fx, moment_high += high_y * fx - high_x * fy;
    if constexpr (stresses) {
      low[0] += fx * low_x, high[0] -= fx * high_x;
      low[1] += fx * low_y, high[1] -= fx * high_y;
      low[2] += fy * low_x, high[2] -= fy * high_x;
      low[3] += fy * low_y, high[3] -= fy * high_y;
    }
  }
};

/// Stores the sums of the rows of a batch as the forces of its pairs.
template <bool stresses>
BLOCKS_INLINE void store_sums(const BatchArrays& batches, int batch,
                              const Sums<stresses>& sums, int i) {
  PairForce* const forces = batches.forces + batch * lane_count + i;
  store_point(&forces->fx, 4, sums.x, sums.y);
  store_point(&forces->moment_low, 4, sums.moment_low, sums.moment_high);
  if constexpr (stresses) {
    PairStress* const stress = batches.stresses + batch * lane_count + i;
    for (int k = 0; k < 4; k += 2) {
      store_point(&stress->low[k], 8, sums.low[k], sums.low[k + 1]);
      store_point(&stress->high[k], 8, sums.high[k], sums.high[k + 1]);
    }
  }
}

/// Step e.: adds the forces of row s. They are equal and opposite and act at one point.
template <bool rigid, bool readings, class Sums>
BLOCKS_INLINE void add_forces(const BatchArrays& batches, int s,
                              const Pairs<rigid>& pair, const Frame& at, Choice acts,
                              Pack normal, Pack shear, int i, Sums& sums) {
  const Pack fx = where(acts, -(normal * at.ty) - shear * at.tx);
  const Pack fy = where(acts, normal * at.tx - shear * at.ty);
  sums.add(fx, fy, at.x - pair.low_x, at.y - pair.low_y, at.x - pair.high_x,
           at.y - pair.high_y);
  if constexpr (readings) {
    ReadingRow& read = batches.readings[s];
    store(read.overlap, i, where(acts, at.overlap));
    store(read.normal_force, i, where(acts, normal));
    store(read.shear_force, i, where(acts, shear));
  }
}

/// What the contacts of each pair of a pack do with the work of its blocks. It is
/// added up if the model keeps an energy account.
template <bool rigid> struct WorkSums {
  ContactWork<Pack> sums = {};
  Pairs<rigid> now;  ///< velocities of half a step before, which do the work

  BLOCKS_INLINE WorkSums(bool has_account, const BatchPairs& pairs,
                         const BlockState& blocks, int i) {
    if (has_account)
      now = Pairs<rigid>(pairs, blocks, 0.0, i);
  }
  /// Adds the work of a row. v: velocity of the springs; normal_energy(state): that of
  /// the normal spring.
  template <class Energy>
  BLOCKS_INLINE void
  add(Choice acts, double dt, const Frame& at, const Point& v,
      const ContactMotion<Pack>& motion, const ContactState<Pack>& before,
      const ContactState<Pack>& after, const ContactForce<Pack>& force,
      Pack is_hysteretic, const Energy& normal_energy) {
    each_work(
        [&](Pack & sum, const Pack& x)
            __attribute__((always_inline)) { sum += where(acts, x); },
        sums,
        work_of(
            step_of(dt, motion, before, after, force, is_hysteretic, normal_energy)));
    // The springs move with other velocities than the blocks, which is an error of the
    // integration.
    const Point moved = now.velocity(at.x - now.low_x, at.y - now.low_y);
    const Pack x = moved[0] - v[0], y = moved[1] - v[1];
    const Pack closing = x * at.ty - y * at.tx, sliding = x * at.tx + y * at.ty;
    const Pack work = dt * (force.normal * closing + force.shear * sliding);
    sums.integration += where(acts, work);
  }
  /// Stores the sums of lanes i and following of a batch.
  BLOCKS_INLINE void store_in(PairWork* works) const {
    constexpr int stride = sizeof(PairWork) / sizeof(double);
    store_point(&works->friction, stride, sums.friction, sums.dashpots);
    store_point(&works->breaking, stride, sums.breaking, sums.hysteresis);
    store_point(&works->dilation, stride, sums.dilation, sums.integration);
    store_point(&works->before, stride, sums.before, sums.after);
  }
};

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
