// The motion of blocks (kernels.hpp). Included once for each instruction set, in a
// namespace of its own.
#include "dynamics/kernels/corner_motion_body.hpp"
#include "dynamics/kernels/free_lanes_body.hpp"
#include "dynamics/kernels/inertial_mass_body.hpp"
#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// The Cayley rotation, h = spin dt / 2 (docs/theory.md#corners). It is orthogonal to
/// round-off and needs no trigonometric functions.
struct Cayley {
  Pack c, s;
  BLOCKS_INLINE explicit Cayley(Pack turn) {
    const Pack h = 0.5 * turn, scale = 1.0 / (1.0 + h * h);
    c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
  }
  /// Returns R m.
  BLOCKS_INLINE Tensor times(const Tensor& m) const {
    return {c * m[0] - s * m[2], c * m[1] - s * m[3], s * m[0] + c * m[2],
            s * m[1] + c * m[3]};
  }
  /// Returns R m R^T for a symmetric tensor.
  BLOCKS_INLINE Tensor turned(const Tensor& m) const {
    const Tensor t = times({m[0], m[1], m[1], m[3]});
    const Pack t12 = t[0] * s + t[1] * c, t21 = t[2] * c - t[3] * s;
    const Pack shear = 0.5 * (t12 + t21);
    return {t[0] * c - t[1] * s, shear, shear, t[2] * s + t[3] * c};
  }
};

/// The change of the arms of a pack of blocks in the step.
struct ArmMotion {
  Tensor gradient;  ///< the new deformation gradient
  Pack stretch;     ///< no arm is longer than `longest` times `stretch`
  Pack change;      ///< [L] no arm changes by more
};

/// Moves the arms of rigid blocks. The Cayley rotation turns by 2 atan(turn / 2), which
/// is less than `turn`. The scale keeps the gradient a rotation, whatever the number of
/// steps.
BLOCKS_INLINE ArmMotion move_rigid_arms(const Tensor& before, const Cayley& rotation,
                                        Pack turn, Pack longest) {
  const Pack c = rotation.c * before[0] - rotation.s * before[2];
  const Pack s = rotation.s * before[0] + rotation.c * before[2];
  const Pack scale = 1.5 - 0.5 * (c * c + s * s);
  const Mask turns = turn != 0.0;
  const Pack cosine = turns ? c * scale : before[0];
  const Pack sine = turns ? s * scale : before[2];
  return {{cosine, -sine, sine, cosine},
          Pack{} + 1.0,
          longest * (absolute(turn) + (turns ? Pack{} + 0x1p-49 : Pack{}))};
}

/// Moves the arms of deformable blocks: gradient = R (I + strain rate dt) gradient.
/// `stretch` is the largest singular value of the gradient, rounded up.
BLOCKS_INLINE ArmMotion move_deformable_arms(const Tensor& before,
                                             const Cayley& rotation, const Tensor& rate,
                                             double dt, Pack longest) {
  const Tensor step = rotation.times(
      {1.0 + dt * rate[0], dt * rate[1], dt * rate[2], 1.0 + dt * rate[3]});
  const Tensor g = {step[0] * before[0] + step[1] * before[2],
                    step[0] * before[1] + step[1] * before[3],
                    step[2] * before[0] + step[3] * before[2],
                    step[2] * before[1] + step[3] * before[3]};
  const Pack squares = (g[0] * g[0] + g[1] * g[1]) + (g[2] * g[2] + g[3] * g[3]);
  const Pack twice_area = 2.0 * (g[0] * g[3] - g[1] * g[2]);
  const Pack gap = (squares - twice_area) * (squares + twice_area);
  const Pack stretch = 1.0000001 * root(0.5 * (squares + root(larger(gap, Pack{}))));
  const Pack x = step[0] - 1.0, y = step[3] - 1.0;
  const Pack strain = root((x * x + y * y) + (step[1] * step[1] + step[2] * step[2]));
  // The arms before the step may have been longer than the new ones, by a part of
  // strain / (1 - strain).
  return {g, stretch, longest * stretch * (strain + 0x1p-49) * (1.0 + 2.0 * strain)};
}

/// The results of each lane (Moved).
struct MovedLanes {
  Pack largest = {}, bound = {}, sum = {};
  Mask block = Mask{} - 1;
  std::uint64_t near_edge = 0;

  BLOCKS_INLINE Moved all() const {
    Moved moved;
    for (int k = 0; k < width; ++k) {
      const int in_lane = static_cast<int>(block[k]);
      if (largest[k] > moved.largest ||
          (largest[k] == moved.largest && in_lane < moved.block))
        moved.largest = largest[k], moved.block = in_lane;
      moved.bound = bound[k] > moved.bound ? bound[k] : moved.bound;
      moved.sum += sum[k];
    }
    moved.near_edge = near_edge;
    return moved;
  }
};

/// Returns bit k for each moving block k that may be outside the domain: some point
/// within `reach` of its centroid is not inside.
BLOCKS_INLINE std::uint64_t near_edge(Mask moves, const Points& centroid, Pack reach,
                                      const Rectangle& domain) {
  const Points lowest = centroid - twice(reach), highest = centroid + twice(reach);
  const Points lower = everywhere(domain.lower_x, domain.lower_y);
  const Points upper = everywhere(domain.upper_x, domain.upper_y);
  Mask inside[2];
  for (int i = 0; i < 2; ++i)
    inside[i] = (lowest.part[i] >= lower.part[i]) & (highest.part[i] <= upper.part[i]);
  if (!any(~(inside[0] & inside[1])))
    return 0;
  const Mask outside = moves & ~(even(inside[0], inside[1], EachLane()) &
                                 odd(inside[0], inside[1], EachLane()));
  std::uint64_t bits = 0;
  for (int k = 0; k < width; ++k)
    bits |= static_cast<std::uint64_t>(outside[k] & 1) << k;
  return bits;
}

/// Moves the blocks of a pack, which begins with block b.
template <bool rigid, class Lanes>
BLOCKS_INLINE void move_pack(const BlockColumns& blocks, const double* longest_arm,
                             double* path, const Rectangle& domain, int first, int b,
                             Lanes lanes, double dt, MovedLanes& moved) {
  const Mask moves = moving_lanes(blocks, b, lanes);
  // (3). The distance is that of the stored centroids, because rounding may make it
  // larger than velocity times dt.
  const Points from = load_columns<2>(blocks.centroid, b, lanes);
  const Points centroid = from + dt * load_columns<2>(blocks.velocity, b, lanes);
  const Pack went = root(squared_norm(centroid - from));
  store_columns(blocks.centroid, b, lanes, select(moves, centroid, from));
  const Pack turn = dt * load(blocks.spin + b, lanes);
  const Pack angle = load(blocks.angle + b, lanes);
  store(blocks.angle + b, lanes, moves ? angle + turn : angle);

  // (13)-(15)
  const Cayley rotation(turn);
  const Pack longest = load(longest_arm + b, lanes);
  const Tensor before = load_rows<4>(blocks.gradient, b, lanes);
  ArmMotion arms;
  if constexpr (rigid) {
    arms = move_rigid_arms(before, rotation, turn, longest);
  } else {
    const Tensor stress = load_rows<4>(blocks.stress, b, lanes);
    store_rows(blocks.stress, b, lanes, select(moves, rotation.turned(stress), stress));
    const Tensor rate = load_rows<4>(blocks.strain_rate, b, lanes);
    store_rows(blocks.strain_rate, b, lanes,
               select(moves, rotation.turned(rate), rate));
    arms = move_deformable_arms(before, rotation, rate, dt, longest);
  }
  store_rows(blocks.gradient, b, lanes, select(moves, arms.gradient, before));
  move_corners(blocks, b, lanes, arms.gradient, centroid);

  const Pack bound = 1.0000001 * (went + 2.0 * arms.change);
  moved.bound = larger(moves ? bound : Pack{}, moved.bound);
  const Pack before_step = load(path + b, lanes);
  const Pack after_step = before_step + (bound + 0x1p-51 * before_step);
  store(path + b, lanes, moves ? after_step : before_step);
  const Pack distance = went + arms.change, reached = moves ? distance : Pack{};
  const Mask farther = reached > moved.largest;
  moved.largest = farther ? reached : moved.largest;
  moved.block = farther ? b + number_of_each_lane(EachLane()) : moved.block;
  // If the square of the turn overflows, the gradient becomes NaN but the distance does
  // not.
  const Tensor& g = arms.gradient;
  const Pack numbers = distance + ((g[0] + g[1]) + (g[2] + g[3]));
  moved.sum += moves ? numbers : Pack{};
  moved.near_edge |= near_edge(moves, centroid, longest * arms.stretch, domain)
                     << (b - first);
}

template <bool rigid>
Moved move_range(const BlockColumns blocks, const double* longest_arm, double* path,
                 const Rectangle domain, int first, int last, double dt) {
  MovedLanes moved;
  each_pack(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        move_pack<rigid>(blocks, longest_arm, path, domain, first, b, lanes, dt, moved);
      });
  return moved.all();
}

/// Returns D less the damping of vibration, with S the root of the effective masses:
/// D -= z sqrt(C11) (S e + e S), e: strain rates (docs/cracks.md#damping-of-vibration).
/// Blocks without damping keep their bits, because 0 times a rate may be -0 or NaN.
template <class Lanes>
BLOCKS_INLINE Symmetric damp_vibration(const BlockColumns& blocks,
                                       const VibrationDamping& damping, Pack factor,
                                       Mask free, int first, int b, Lanes lanes,
                                       double kick, const StrainMass& mass,
                                       const Symmetric& driving) {
  const Mask damps = free & (factor > 0.0);
  const Symmetric rate = symmetric(load_rows<4>(damping.rates, b - first, lanes));
  const Symmetric slows = factor * symmetric_product(mass.square_root(), rate);
  if (damping.work != nullptr) {
    const Pack work = kick * load(blocks.area + b, lanes) * slows.product(rate);
    const Pack before = load(damping.work + b, lanes);
    store(damping.work + b, lanes, damps ? before + work : before);
  }
  const Symmetric damped = driving - slows;
  return {damps ? damped.xx : driving.xx, damps ? damped.xy : driving.xy,
          damps ? damped.yy : driving.yy};
}

/// (10), (12) for the blocks [first, last). damped: whether vibration is damped.
template <bool damped>
void update_range(const BlockColumns& blocks, const MaterialColumns& materials,
                  const VibrationDamping& damping, int first, int last, double kick,
                  double dt) {
  each_pack(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        // (10)
        const StrainMass mass(blocks, b, lanes);
        const Tensor stress = load_rows<4>(blocks.stress, b, lanes);
        const Tensor before = load_rows<4>(blocks.strain_rate, b, lanes);
        Symmetric driving = driving_stress(blocks, stress, b, lanes);
        if constexpr (damped)
          driving = damp_vibration(blocks, damping,
                                   load(materials.damping + (b - first), lanes), free,
                                   first, b, lanes, kick, mass, driving);
        const Symmetric more = mass.accelerations(driving);
        const Tensor rate =
            tensor({before[0] + kick * more.xx, before[1] + kick * more.xy,
                    before[3] + kick * more.yy});
        store_rows(blocks.strain_rate, b, lanes, select(free, rate, before));
        // (12)
        const Pack c11 = load(materials.c11 + (b - first), lanes);
        const Pack c12 = load(materials.c12 + (b - first), lanes);
        const Pack twice_shear = load(materials.twice_shear + (b - first), lanes);
        const Tensor after = tensor({stress[0] + dt * (c11 * rate[0] + c12 * rate[3]),
                                     stress[1] + dt * twice_shear * rate[1],
                                     stress[3] + dt * (c12 * rate[0] + c11 * rate[3])});
        store_rows(blocks.stress, b, lanes, select(free, after, stress));
      });
}

}  // namespace

void update_velocities(const BlockColumns& blocks, int first, int last,
                       double gravity_x, double gravity_y, double kick) {
  const Points gravity = everywhere(gravity_x, gravity_y);
  each_pack(
      first, last, [&](int b, auto lanes) __attribute__((always_inline)) {
        const Mask free = free_lanes(blocks, b, lanes);
        const Points mass = twice(load(blocks.mass + b, lanes));
        const Points force = load_columns<2>(blocks.force, b, lanes);
        const Points velocity = load_columns<2>(blocks.velocity, b, lanes);
        store_columns(
            blocks.velocity, b, lanes,
            select(free,
                   velocity + kick * scaled(blocks, force / mass + gravity, b, lanes),
                   velocity));
        const Pack moment = load(blocks.moment + b, lanes);
        const Pack spin = load(blocks.spin + b, lanes);
        const Pack faster =
            spin +
            kick * scaled(blocks, moment / load(blocks.inertia + b, lanes), b, lanes);
        store(blocks.spin + b, lanes, free ? faster : spin);
      });
}

void update_strain(const BlockColumns& blocks, const MaterialColumns& materials,
                   const VibrationDamping& damping, int first, int last, double kick,
                   double dt) {
  const auto update =
      damping.rates != nullptr ? update_range<true> : update_range<false>;
  update(blocks, materials, damping, first, last, kick, dt);
}

Moved move(const BlockColumns& blocks, const double* longest_arm, double* path,
           const Rectangle& domain, bool rigid, int first, int last, double dt) {
  const auto move_all = rigid ? move_range<true> : move_range<false>;
  return move_all(blocks, longest_arm, path, domain, first, last, dt);
}

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
