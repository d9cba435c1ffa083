// The computations of block_motion.hpp. Included once for each instruction set, in a
// namespace of its own; calls nothing that is not compiled here.
#include <type_traits>

#include "dynamics/block_motion.hpp"
#include "dynamics/simd_set.hpp"

namespace blocks::dynamics::BLOCKS_LANES {
namespace {

/// Which lanes hold a block that moves.
template <class Lanes>
BLOCKS_INLINE Mask free_lanes(const BlockColumns& blocks, int b, Lanes lanes) {
  typedef int Fixities __attribute__((vector_size(width * sizeof(int))));
  Fixities why = Fixities{} + 1;
  __builtin_memcpy(&why, blocks.fixity + b, lanes.count * sizeof(int));
  return __builtin_convertvector(why == 0, Mask);
}

/// `changed` where a block is free, `kept` elsewhere.
template <int rows>
BLOCKS_INLINE Rows<rows> select(Mask free, const Rows<rows>& changed,
                                const Rows<rows>& kept) {
  Rows<rows> all;
  for (int i = 0; i < rows; ++i)
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
  /// R m, by rows 11, 12, 21, 22.
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

/// What the sum of a rigid block's swing grows by: that by which turn and Cayley
/// rotation differ, and round-off.
BLOCKS_INLINE Set beside_angle(Set turn, Set angle, Set longest) {
  const Set beside = longest * (absolute(turn * turn * turn) / 12.0 +
                                0x1p-50 * (1.0 + absolute(angle)));
  return turn != 0.0 ? beside : Set{};
}

/// x, y, x, y ..., so many numbers.
template <std::size_t... k>
BLOCKS_INLINE auto in_turn(double x, double y, std::index_sequence<k...>) {
  constexpr int count = sizeof...(k);
  using Which = decltype(Numbers<count>{} < Numbers<count>{});
  const Numbers<count> none = {};
  return Which{-static_cast<long long>(k % 2)...} ? y - none : x - none;
}
/// y, x of each corner.
template <std::size_t... k, class Corners>
BLOCKS_INLINE Corners swapped(Corners x, std::index_sequence<k...>) {
  return __builtin_shufflevector(x, x, (k ^ 1)...);
}

/// Calls work(count, c) for corners c .. c + count - 1 of a block, as many at a time as
/// a register holds, then what is left.
template <class Work>
BLOCKS_INLINE void each_piece(int first, int last, const Work& work) {
  int c = first;
  for (; c + width / 2 <= last; c += width / 2)
    work(std::integral_constant<int, width / 2>(), c);
  if constexpr (width > 4)
    if (c + 2 <= last) {
      work(std::integral_constant<int, 2>(), c);
      c += 2;
    }
  if constexpr (width > 2)
    if (c < last)
      work(std::integral_constant<int, 1>(), c);
}

/// One column out of those of several corners: of each pair what `choose` takes.
template <int corners, class Choose>
BLOCKS_INLINE Numbers<2> one_of(Numbers<2 * corners> x, const Choose& choose) {
  if constexpr (corners == 1)
    return x;
  else if constexpr (corners == 2)
    return choose(__builtin_shufflevector(x, x, 0, 1),
                  __builtin_shufflevector(x, x, 2, 3));
  else
    return one_of<2>(choose(__builtin_shufflevector(x, x, 0, 1, 2, 3),
                            __builtin_shufflevector(x, x, 4, 5, 6, 7)),
                     choose);
}
constexpr auto larger = [](auto a, auto b) __attribute__((always_inline)) {
  return a > b ? a : b;
};
constexpr auto smaller = [](auto a, auto b) __attribute__((always_inline)) {
  return a < b ? a : b;
};

/// Extents of blocks b .. along both axes, [L].
template <class Lanes>
BLOCKS_INLINE Point extents(const BlockColumns& blocks, int b, Lanes lanes) {
  alignas(64) double extent[2 * width] = {};
  for (int k = 0; k < lanes.count; ++k) {
    Numbers<2> least = Numbers<2>{} + __builtin_inf(), most = -least;
    each_piece(
        blocks.first_corner[b + k], blocks.first_corner[b + k + 1],
        [&](auto corners, int c) __attribute__((always_inline)) {
          const auto arm = load<2 * corners>(blocks.arm + 2 * std::ptrdiff_t{c});
          least = smaller(one_of<corners>(arm, smaller), least);
          most = larger(one_of<corners>(arm, larger), most);
        });
    store<2>(extent + 2 * k, most - least);
  }
  return load_columns<2>(extent, 0, AllLanes{});
}

/// What becomes of the corners of a set of blocks.
struct CornerMotion {
  alignas(64) double t11[width], t12[width], t21[width], t22[width];  ///< transform
  alignas(64) double x[width], y[width];                              ///< [L] centroid
};

/// (13)-(15): arm = transform arm and corner = centroid + arm, of block k of the set.
/// Returns the square of what an arm has changed by at most.
BLOCKS_INLINE double move_corners(const BlockColumns& blocks,
                                  const CornerMotion& motion, int k, int first,
                                  int last) {
  Numbers<2> farthest = {};
  each_piece(
      first, last, [&](auto corners, int c) __attribute__((always_inline)) {
        using Columns = Numbers<2 * corners>;
        constexpr auto numbers = std::make_index_sequence<2 * corners>();
        double* const arms = blocks.arm + 2 * std::ptrdiff_t{c};
        const Columns old = load<2 * corners>(arms);
        const Columns arm =
            in_turn(motion.t11[k], motion.t22[k], numbers) * old +
            in_turn(motion.t12[k], motion.t21[k], numbers) * swapped(old, numbers);
        store<2 * corners>(arms, arm);
        store<2 * corners>(blocks.corner + 2 * std::ptrdiff_t{c},
                           in_turn(motion.x[k], motion.y[k], numbers) + arm);
        const Columns change = arm - old, squares = change * change;
        const Columns sums = squares + swapped(squares, numbers);
        farthest = larger(one_of<corners>(larger(sums, Columns{}), larger), farthest);
      });
  return farthest[0];
}

template <std::size_t... k> BLOCKS_INLINE Mask each_lane(std::index_sequence<k...>) {
  return Mask{k...};
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

/// Moves the blocks b .. of a set, the first of which is number `place` of the range.
template <bool rigid, class Lanes>
BLOCKS_INLINE void move_set(const BlockColumns& blocks, const SwingColumns& swing,
                            const Rectangle& domain, int b, int place, Lanes lanes,
                            double dt, MovedLanes& moved) {
  const Mask free = free_lanes(blocks, b, lanes);
  // (3); the way is not the shift: of half a unit in the last place it makes a whole
  // one
  const Point velocity = load_columns<2>(blocks.velocity, b, lanes);
  const Point from = load_columns<2>(blocks.centroid, b, lanes);
  const Point centroid = {from[0] + dt * velocity[0], from[1] + dt * velocity[1]};
  const Set along_x = centroid[0] - from[0], along_y = centroid[1] - from[1];
  const Set went = root(along_x * along_x + along_y * along_y);
  const Set turn = dt * load(blocks.spin + b, lanes);
  const Set angle_before = load(blocks.angle + b, lanes), angle = angle_before + turn;
  const Cayley rotation(turn);
  store_columns<2>(blocks.centroid, b, lanes, select(free, centroid, from));
  store(blocks.angle + b, lanes, free ? angle : angle_before);

  Tensor transform = {rotation.c, -rotation.s, rotation.s, rotation.c};
  if constexpr (!rigid) {
    const Tensor stress = load_columns<4>(blocks.stress, b, lanes);
    store_columns<4>(blocks.stress, b, lanes,
                     select(free, rotation.turned(stress), stress));
    const Tensor rate = load_columns<4>(blocks.strain_rate, b, lanes);
    transform = rotation.times(
        {1.0 + dt * rate[0], dt * rate[1], dt * rate[2], 1.0 + dt * rate[3]});
    store_columns<4>(blocks.strain_rate, b, lanes,
                     select(free, rotation.turned(rate), rate));
  }

  CornerMotion motion;
  alignas(64) double farthest[width] = {};
  store<width>(motion.t11, transform[0]), store<width>(motion.t12, transform[1]);
  store<width>(motion.t21, transform[2]), store<width>(motion.t22, transform[3]);
  store<width>(motion.x, centroid[0]), store<width>(motion.y, centroid[1]);
  for (int k = 0; k < lanes.count; ++k)
    if (blocks.fixity[b + k] == Fixity{})
      farthest[k] = move_corners(blocks, motion, k, blocks.first_corner[b + k],
                                 blocks.first_corner[b + k + 1]);

  const Set longest = load(swing.longest + b, lanes);
  const Set sum_before = load(swing.sum + b, lanes);
  Set swung, stretch = Set{} + 1.0, rounded;
  if constexpr (rigid) {
    rounded = beside_angle(turn, angle, longest);
    swung = longest * absolute(turn) + rounded;
  } else {
    swung = root(load(farthest, AllLanes{}));
    // by columns: 11, 21, 12, 22
    const Tensor before = load_columns<4>(swing.shape, b, lanes);
    const Tensor m = {transform[0] * before[0] + transform[1] * before[1],
                      transform[2] * before[0] + transform[3] * before[1],
                      transform[0] * before[2] + transform[1] * before[3],
                      transform[2] * before[2] + transform[3] * before[3]};
    store_columns<4>(swing.shape, b, lanes, select(free, m, before));
    stretch = root((m[0] * m[0] + m[2] * m[2]) + (m[1] * m[1] + m[3] * m[3]));
    rounded = 0x1p-49 * longest * stretch;
  }
  const Set sum = sum_before + rounded;
  store(swing.sum + b, lanes, free ? sum : sum_before);
  const Set distance = went + swung;
  const Set way_before = load(swing.way + b, lanes);
  const Set way = 1.0000001 * (went + 2.0 * swung) + 0x1p-52 * way_before;
  const Set way_after = way_before + way;
  store(swing.way + b, lanes, free ? way_after : way_before);

  const Set grown = way + 0x1p-52 * way_after;
  moved.way = larger(free ? grown : Set{}, moved.way);
  // NaN where a turn overflows, whose way does not
  const Set numbers =
      distance + ((transform[0] + transform[1]) + (transform[2] + transform[3]));
  moved.sum += free ? numbers : Set{};
  const Set reached = free ? distance : Set{};
  const Mask farther = reached > moved.largest;
  moved.largest = farther ? reached : moved.largest;
  moved.block = farther ? b + each_lane(EachLane()) : moved.block;

  const Set reach = longest * stretch + sum;
  const Mask well_inside = (centroid[0] - reach >= domain.lower_x) &
                           (centroid[1] - reach >= domain.lower_y) &
                           (centroid[0] + reach <= domain.upper_x) &
                           (centroid[1] + reach <= domain.upper_y);
  if (const Mask near_edge = free & ~well_inside; any(near_edge))
    for (int k = 0; k < lanes.count; ++k)
      moved.near_edge |= (near_edge[k] & std::uint64_t{1}) << (place + k);
}

template <bool rigid>
Moved move_range(const BlockColumns blocks, const SwingColumns swing,
                 const Rectangle domain, int first, int last, double dt) {
  MovedLanes moved;
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        move_set<rigid>(blocks, swing, domain, b, b - first, lanes, dt, moved);
      });
  return moved.all();
}

}  // namespace

void update_velocities(const BlockColumns& blocks, int first, int last,
                       double gravity_x, double gravity_y, double dt) {
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        const Set mass = load(blocks.mass + b, lanes);
        const Point force = load_columns<2>(blocks.force, b, lanes);
        const Point before = load_columns<2>(blocks.velocity, b, lanes);
        const Point after = {before[0] + dt * (force[0] / mass + gravity_x),
                             before[1] + dt * (force[1] / mass + gravity_y)};
        store_columns<2>(blocks.velocity, b, lanes, select(free, after, before));
        const Set moment = load(blocks.moment + b, lanes);
        const Set spin = load(blocks.spin + b, lanes);
        const Set faster = spin + dt * (moment / load(blocks.inertia + b, lanes));
        store(blocks.spin + b, lanes, free ? faster : spin);
      });
}

void update_strain_rates(const BlockColumns& blocks, int first, int last, double dt) {
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        const Point l = extents(blocks, b, lanes);
        const Set mass_per_area =
            0.25 * load(blocks.mass + b, lanes) / load(blocks.area + b, lanes);
        const Set m11 = l[0] * l[0] * mass_per_area, m22 = l[1] * l[1] * mass_per_area;
        const Tensor applied = load_columns<4>(blocks.applied, b, lanes);
        const Tensor internal = load_columns<4>(blocks.stress, b, lanes);
        const Tensor rate = load_columns<4>(blocks.strain_rate, b, lanes);
        const Set shear = 0.5 * (applied[1] + applied[2]) - internal[1];
        const Set rate12 = rate[1] + dt * shear / (0.5 * (m11 + m22));
        const Tensor after = {rate[0] + dt * (applied[0] - internal[0]) / m11, rate12,
                              rate12, rate[3] + dt * (applied[3] - internal[3]) / m22};
        store_columns<4>(blocks.strain_rate, b, lanes, select(free, after, rate));
      });
}

void update_stress(const BlockColumns& blocks, const Moduli& moduli, int first,
                   int last, double dt) {
  each_set(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        const Set c11 = load(moduli.c11 + (b - first), lanes);
        const Set c12 = load(moduli.c12 + (b - first), lanes);
        const Set twice_shear = load(moduli.twice_shear + (b - first), lanes);
        const Tensor rate = load_columns<4>(blocks.strain_rate, b, lanes);
        const Tensor before = load_columns<4>(blocks.stress, b, lanes);
        const Set s12 = before[1] + dt * twice_shear * rate[1];
        const Tensor after = {before[0] + dt * (c11 * rate[0] + c12 * rate[3]), s12,
                              s12, before[3] + dt * (c12 * rate[0] + c11 * rate[3])};
        store_columns<4>(blocks.stress, b, lanes, select(free, after, before));
      });
}

Moved move(const BlockColumns& blocks, const SwingColumns& swing,
           const Rectangle& domain, bool rigid, int first, int last, double dt) {
  const auto move_all = rigid ? move_range<true> : move_range<false>;
  return move_all(blocks, swing, domain, first, last, dt);
}

}  // namespace blocks::dynamics::BLOCKS_LANES
