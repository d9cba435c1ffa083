// The masses that resist forces and stresses, for the motion kernels. MSCALE scales
// them.
#pragma once

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Returns the acceleration of blocks with inertial masses from that with their masses.
template <class Lanes>
BLOCKS_INLINE Pack scaled(const BlockColumns& blocks, Pack acceleration, int b,
                          Lanes lanes) {
  return blocks.scale == nullptr ? acceleration
                                 : acceleration / load(blocks.scale + b, lanes);
}
template <class Lanes>
BLOCKS_INLINE Points scaled(const BlockColumns& blocks, const Points& acceleration,
                            int b, Lanes lanes) {
  return blocks.scale == nullptr ? acceleration
                                 : acceleration / twice(load(blocks.scale + b, lanes));
}

/// A symmetric tensor of each lane.
struct Symmetric {
  Pack xx, xy, yy;
  BLOCKS_INLINE Pack square() const { return (xx * xx + yy * yy) + 2.0 * (xy * xy); }
  BLOCKS_INLINE Pack product(const Symmetric& o) const {
    return (xx * o.xx + yy * o.yy) + 2.0 * (xy * o.xy);
  }
};
BLOCKS_INLINE Symmetric operator-(const Symmetric& a, const Symmetric& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
BLOCKS_INLINE Symmetric operator*(Pack factor, const Symmetric& a) {
  return {factor * a.xx, factor * a.xy, factor * a.yy};
}
/// Returns the symmetric part of the product of two symmetric tensors.
BLOCKS_INLINE Symmetric symmetric_product(const Symmetric& a, const Symmetric& b) {
  return {a.xx * b.xx + a.xy * b.xy,
          0.5 * ((a.xx + a.yy) * b.xy + a.xy * (b.xx + b.yy)),
          a.yy * b.yy + a.xy * b.xy};
}

/// The effective masses of the strain rates of a pack of blocks, the tensor M of
/// docs/theory.md#strain-rates-and-stress, [M].
struct StrainMass {
  Symmetric m;
  Pack trace, determinant;

  template <class Lanes>
  BLOCKS_INLINE StrainMass(const BlockColumns& blocks, int b, Lanes lanes) {
    const Tensor g = load_rows<4>(blocks.gradient, b, lanes);
    const Tensor j = load_rows<4>(blocks.second_moment, b, lanes);
    const Pack per_area = 3.0 / load(blocks.area + b, lanes);
    const Pack factor =
        blocks.scale == nullptr ? per_area : per_area * load(blocks.scale + b, lanes);
    const Pack a11 = g[0] * j[0] + g[1] * j[1], a12 = g[0] * j[1] + g[1] * j[3];
    const Pack a21 = g[2] * j[0] + g[3] * j[1], a22 = g[2] * j[1] + g[3] * j[3];
    m = factor * Symmetric{a11 * g[0] + a12 * g[1], a11 * g[2] + a12 * g[3],
                           a21 * g[2] + a22 * g[3]};
    trace = m.xx + m.yy;
    // In a sliver the determinant is lost in round-off.
    determinant =
        larger(m.xx * m.yy - m.xy * m.xy, min_moment_share * (0.5 * (trace * trace)));
  }
  /// Returns the strain accelerations e under the stresses s, (M e + e M) / 2 = s.
  BLOCKS_INLINE Symmetric accelerations(const Symmetric& s) const {
    // By Cayley and Hamilton, with the adjugate A of M:
    // e = (det M s + A s A) / (tr M det M).
    const Pack t11 = m.yy * s.xx - m.xy * s.xy, t12 = m.yy * s.xy - m.xy * s.yy;
    const Pack t21 = m.xx * s.xy - m.xy * s.xx, t22 = m.xx * s.yy - m.xy * s.xy;
    const Pack scale = 1.0 / (trace * determinant);
    return scale * Symmetric{determinant * s.xx + (t11 * m.yy - t12 * m.xy),
                             determinant * s.xy + (t12 * m.xx - t11 * m.xy),
                             determinant * s.yy + (t22 * m.xx - t21 * m.xy)};
  }
  /// Returns the square root of the tensor, [M^1/2].
  BLOCKS_INLINE Symmetric square_root() const {
    const Pack of_determinant = root(determinant);
    const Pack scale = 1.0 / root(trace + 2.0 * of_determinant);
    return scale * Symmetric{m.xx + of_determinant, m.xy, m.yy + of_determinant};
  }
};

/// Returns D, the symmetric part of the applied stress less the internal stress.
template <class Lanes>
BLOCKS_INLINE Symmetric driving_stress(const BlockColumns& blocks, const Tensor& stress,
                                       int b, Lanes lanes) {
  const Tensor applied = load_rows<4>(blocks.applied, b, lanes);
  return {applied[0] - stress[0], 0.5 * (applied[1] + applied[2]) - stress[1],
          applied[3] - stress[3]};
}

BLOCKS_INLINE Symmetric symmetric(const Tensor& t) { return {t[0], t[1], t[3]}; }
BLOCKS_INLINE Tensor tensor(const Symmetric& s) { return {s.xx, s.xy, s.xy, s.yy}; }

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
