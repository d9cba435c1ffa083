// The computations of block_motion.hpp. Included once for each instruction set, in a
// namespace of its own; calls nothing that is not compiled here.
#include "dynamics/block_corners.hpp"
#include "dynamics/block_motion.hpp"
#include "dynamics/simd_set.hpp"

namespace blocks::dynamics::BLOCKS_LANES {
namespace {

/// Which lanes hold a block that moves.
template <class Lanes>
BLOCKS_INLINE Mask free_lanes(const BlockColumns& blocks, int b, Lanes lanes) {
  return __builtin_convertvector(load_ints(blocks.fixity + b, lanes) == 0, Mask);
}

/// `changed` where a block is free, `kept` elsewhere.
BLOCKS_INLINE Points select(Mask free, const Points& changed, const Points& kept) {
  return {low_turns(free, free, EachLane()) ? changed.part[0] : kept.part[0],
          high_turns(free, free, EachLane()) ? changed.part[1] : kept.part[1]};
}
BLOCKS_INLINE Tensor select(Mask free, const Tensor& changed, const Tensor& kept) {
  Tensor all;
  for (int i = 0; i < 4; ++i)
    all[i] = free ? changed[i] : kept[i];
  return all;
}

/// Orthogonal to round-off and free of trigonometry: h = spin dt / 2 (rule 6).
struct Cayley {
  Set c, s;
  BLOCKS_INLINE explicit Cayley(Set turn) {
    const Set h = 0.5 * turn, scale = 1.0 / (1.0 + h * h);
    c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
  }
  /// R m.
  BLOCKS_INLINE Tensor times(const Tensor& m) const {
    return {c * m[0] - s * m[2], c * m[1] - s * m[3], s * m[0] + c * m[2],
            s * m[1] + c * m[3]};
  }
  /// R m R^T of a symmetric tensor.
  BLOCKS_INLINE Tensor turned(const Tensor& m) const {
    const Tensor t = times({m[0], m[1], m[1], m[3]});
    const Set t12 = t[0] * s + t[1] * c, t21 = t[2] * c - t[3] * s;
    const Set shear = 0.5 * (t12 + t21);
    return {t[0] * c - t[1] * s, shear, shear, t[2] * s + t[3] * c};
  }
};

/// How far the arms of a set of blocks have swung, and what of Swing follows from it.
struct Swung {
  Set arm;      ///< [L] no arm has changed by more
  Set any_arm;  ///< [L] nor would one `longest` long in any direction
  Set rounded;  ///< [L] what the sum grows by
  Set stretch;  ///< no arm is longer than `longest` times that, and the sum
};

/// Of rigid blocks: by the angle, and that by which turn and Cayley rotation differ.
BLOCKS_INLINE Swung swung_rigidly(Set turn, Set angle, Set longest) {
  const Set beside = longest * (absolute(turn * turn * turn) / 12.0 +
                                0x1p-50 * (1.0 + absolute(angle)));
  const Set rounded = turn != 0.0 ? beside : Set{};
  const Set arm = longest * absolute(turn) + rounded;
  return {arm, arm, rounded, Set{} + 1.0};
}

/// Of deformable blocks: shape = transform shape, whose columns 11, 21, 12, 22 are
/// kept.
template <class Lanes>
BLOCKS_INLINE Swung swung_in_shape(const SwingColumns& swing, int b, Lanes lanes,
                                   Mask free, const Tensor& transform, Set farthest,
                                   Set longest) {
  const Tensor before = load_rows<4>(swing.shape, b, lanes);
  const Tensor shape = {transform[0] * before[0] + transform[1] * before[1],
                        transform[2] * before[0] + transform[3] * before[1],
                        transform[0] * before[2] + transform[1] * before[3],
                        transform[2] * before[2] + transform[3] * before[3]};
  store_rows(swing.shape, b, lanes, select(free, shape, before));
  const Set stretch = root((shape[0] * shape[0] + shape[2] * shape[2]) +
                           (shape[1] * shape[1] + shape[3] * shape[3]));
  const Set x = transform[0] - 1.0, y = transform[3] - 1.0;
  const Set strain = root((x * x + y * y) +
                          (transform[1] * transform[1] + transform[2] * transform[2]));
  const Set rounded = 0x1p-49 * longest * stretch;
  return {root(farthest), longest * strain + rounded, rounded, stretch};
}

/// The extremes of Moved, lane by lane.
struct MovedLanes {
  Set largest = {}, way = {}, sum = {};
  Mask block = Mask{} - 1;
  std::uint64_t near_edge = 0;

  BLOCKS_INLINE Moved all() const {
    Moved moved;
    for (int k = 0; k < width; ++k) {
      const int in_lane = static_cast<int>(block[k]);
      if (largest[k] > moved.largest ||
          (largest[k] == moved.largest && in_lane < moved.block))
        moved.largest = largest[k], moved.block = in_lane;
      moved.way = way[k] > moved.way ? way[k] : moved.way;
      moved.sum += sum[k];
    }
    moved.near_edge = near_edge;
    return moved;
  }
};

/// Bit k: all that is within reach of the centroid of block k may not be inside the
/// domain.
BLOCKS_INLINE std::uint64_t near_edge(Mask free, const Points& centroid, Set reach,
                                      const Rectangle& domain) {
  const Points least = centroid - twice(reach), most = centroid + twice(reach);
  const Points lower = everywhere(domain.lower_x, domain.lower_y);
  const Points upper = everywhere(domain.upper_x, domain.upper_y);
  Mask inside[2];
  for (int i = 0; i < 2; ++i)
    inside[i] = (least.part[i] >= lower.part[i]) & (most.part[i] <= upper.part[i]);
  if (!any(~(inside[0] & inside[1])))
    return 0;
  const Mask outside = free & ~(even(inside[0], inside[1], EachLane()) &
                                odd(inside[0], inside[1], EachLane()));
  std::uint64_t bits = 0;
  for (int k = 0; k < width; ++k)
    bits |= static_cast<std::uint64_t>(outside[k] & 1) << k;
  return bits;
}

/// Moves the blocks b .. of a set.
template <bool rigid, class Lanes>
BLOCKS_INLINE void move_set(const BlockColumns& blocks, const SwingColumns& swing,
                            const Rectangle& domain, int first, int b, Lanes lanes,
                            double dt, MovedLanes& moved) {
  const Mask free = free_lanes(blocks, b, lanes);
  // (3); it went by the difference, not by the shift, of which half a unit in the last
  // place makes a whole one
  const Points from = load_columns<2>(blocks.centroid, b, lanes);
  const Points centroid = from + dt * load_columns<2>(blocks.velocity, b, lanes);
  const Set went = root(squared_norm(centroid - from));
  store_columns(blocks.centroid, b, lanes, select(free, centroid, from));
  const Set turn = dt * load(blocks.spin + b, lanes);
  const Set angle_before = load(blocks.angle + b, lanes), angle = angle_before + turn;
  store(blocks.angle + b, lanes, free ? angle : angle_before);

  // (13)-(15)
  const Cayley rotation(turn);
  Tensor transform = {rotation.c, -rotation.s, rotation.s, rotation.c};
  if constexpr (!rigid) {
    const Tensor stress = load_rows<4>(blocks.stress, b, lanes);
    store_rows(blocks.stress, b, lanes, select(free, rotation.turned(stress), stress));
    const Tensor rate = load_rows<4>(blocks.strain_rate, b, lanes);
    store_rows(blocks.strain_rate, b, lanes, select(free, rotation.turned(rate), rate));
    transform = rotation.times(
        {1.0 + dt * rate[0], dt * rate[1], dt * rate[2], 1.0 + dt * rate[3]});
  }
  const Set farthest = move_corners<rigid>(blocks, b, lanes, transform, centroid);

  const Set longest = load(swing.longest + b, lanes);
  const Swung swung = [&]() __attribute__((always_inline)) {
    if constexpr (rigid)
      return swung_rigidly(turn, angle, longest);
    else
      return swung_in_shape(swing, b, lanes, free, transform, farthest, longest);
  }
  ();
  const Set sum_before = load(swing.sum + b, lanes), sum = sum_before + swung.rounded;
  store(swing.sum + b, lanes, free ? sum : sum_before);
  const Set way_before = load(swing.way + b, lanes);
  const Set way = 1.0000001 * (went + 2.0 * swung.any_arm) + 0x1p-52 * way_before;
  const Set way_after = way_before + way;
  store(swing.way + b, lanes, free ? way_after : way_before);

  const Set grown = way + 0x1p-52 * way_after;
  moved.way = larger(free ? grown : Set{}, moved.way);
  const Set distance = went + swung.arm, reached = free ? distance : Set{};
  const Mask farther = reached > moved.largest;
  moved.largest = farther ? reached : moved.largest;
  moved.block = farther ? b + number_of_each_lane(EachLane()) : moved.block;
  // NaN where a turn overflows, whose way does not
  const Set numbers =
      distance + ((transform[0] + transform[1]) + (transform[2] + transform[3]));
  moved.sum += free ? numbers : Set{};
  moved.near_edge |= near_edge(free, centroid, longest * swung.stretch + sum, domain)
                     << (b - first);
}

template <bool rigid>
Moved move_range(const BlockColumns blocks, const SwingColumns swing,
                 const Rectangle domain, int first, int last, double dt) {
  MovedLanes moved;
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        move_set<rigid>(blocks, swing, domain, first, b, lanes, dt, moved);
      });
  return moved.all();
}

}  // namespace

void update_velocities(const BlockColumns& blocks, int first, int last,
                       double gravity_x, double gravity_y, double dt) {
  const Points gravity = everywhere(gravity_x, gravity_y);
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        const Points mass = twice(load(blocks.mass + b, lanes));
        const Points force = load_columns<2>(blocks.force, b, lanes);
        const Points velocity = load_columns<2>(blocks.velocity, b, lanes);
        store_columns(blocks.velocity, b, lanes,
                      select(free, velocity + dt * (force / mass + gravity), velocity));
        const Set moment = load(blocks.moment + b, lanes);
        const Set spin = load(blocks.spin + b, lanes);
        const Set faster = spin + dt * (moment / load(blocks.inertia + b, lanes));
        store(blocks.spin + b, lanes, free ? faster : spin);
      });
}

void update_strain(const BlockColumns& blocks, const Moduli& moduli, int first,
                   int last, double dt) {
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        // (10)
        const Point l = extents(blocks, b, lanes);
        const Set mass_per_area =
            0.25 * load(blocks.mass + b, lanes) / load(blocks.area + b, lanes);
        const Set m11 = l[0] * l[0] * mass_per_area, m22 = l[1] * l[1] * mass_per_area;
        const Tensor applied = load_rows<4>(blocks.applied, b, lanes);
        const Tensor stress = load_rows<4>(blocks.stress, b, lanes);
        const Tensor before = load_rows<4>(blocks.strain_rate, b, lanes);
        const Set shear = 0.5 * (applied[1] + applied[2]) - stress[1];
        const Set rate12 = before[1] + dt * shear / (0.5 * (m11 + m22));
        const Tensor rate = {before[0] + dt * (applied[0] - stress[0]) / m11, rate12,
                             rate12, before[3] + dt * (applied[3] - stress[3]) / m22};
        store_rows(blocks.strain_rate, b, lanes, select(free, rate, before));
        // (12)
        const Set c11 = load(moduli.c11 + (b - first), lanes);
        const Set c12 = load(moduli.c12 + (b - first), lanes);
        const Set twice_shear = load(moduli.twice_shear + (b - first), lanes);
        const Set s12 = stress[1] + dt * twice_shear * rate[1];
        const Tensor after = {stress[0] + dt * (c11 * rate[0] + c12 * rate[3]), s12,
                              s12, stress[3] + dt * (c12 * rate[0] + c11 * rate[3])};
        store_rows(blocks.stress, b, lanes, select(free, after, stress));
      });
}

Moved move(const BlockColumns& blocks, const SwingColumns& swing,
           const Rectangle& domain, bool rigid, int first, int last, double dt) {
  const auto move_all = rigid ? move_range<true> : move_range<false>;
  return move_all(blocks, swing, domain, first, last, dt);
}

}  // namespace blocks::dynamics::BLOCKS_LANES
