// State of all blocks as a structure of arrays (report Appendix D). Array shapes use n,
// the number of blocks, and m, the number of corners.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

using geometry::Vec2;

/// Whether a block is free, or why no force moves it. A driven block is fixed by_user.
/// A removed block keeps its number and its data, but touches nothing.
enum class Fixity : int {
  free = 0,
  by_user = 1,
  left_domain = 2,
  removed = 3,
  driven = 4,  ///< it moves at a given velocity, whatever the forces (DRIVE)
};

/// Returns a symmetric tensor with the components 11, 12, 22 as rows 11, 12, 21, 22.
inline Eigen::Vector4d tensor_of(const Eigen::Vector3d& symmetric) {
  return {symmetric[0], symmetric[1], symmetric[1], symmetric[2]};
}

/// A block to be created from a simple clockwise outline.
struct NewBlock {
  geometry::Polygon outline;  ///< [L] clockwise
  int material = 0;
  double density = 0.0;  ///< [M/L^3] > 0
  Fixity fixity = Fixity::free;
  int layer = 0;  ///< LAYER card that made it, from 1; 0: none
  /// Joint id of the side from corner i to i + 1; empty: 0 for all sides.
  std::vector<int> joints = {};
};

/// Arrays of all blocks and their corners. Second-order tensors are stored as rows 11,
/// 12, 21, 22. Rotation is positive anticlockwise and stress is positive in tension.
/// Quantities are per unit thickness, in any consistent set of units: [F] force, [L]
/// length, [T] time, [M] mass.
struct Blocks {
  // The corners of block b are first_corner[b] to first_corner[b + 1], half open,
  // clockwise.
  std::vector<int> first_corner = {0};  ///< (n + 1)
  std::vector<int> corner_block;        ///< (m) block of each corner
  std::vector<int> next;                ///< (m) next corner of the block, clockwise
  std::vector<int> previous;            ///< (m) previous corner of the block
  /// (m) joint id of the side that begins at the corner; 0: none (docs/joints.md)
  std::vector<int> joint;
  Eigen::Matrix2Xd arm;     ///< [L] (2, m) corner - centroid at creation (13)
  Eigen::Matrix2Xd corner;  ///< [L] (2, m) centroid + gradient arm (15)

  std::vector<int> material;   ///< (n) material number of the deck, MAT
  std::vector<Fixity> fixity;  ///< (n) FIXED
  std::vector<char> convex;    ///< (n) 1: no re-entrant corner (exact, at creation)
  /// The convex parts of the blocks that are not convex, cut at creation. Each part is
  /// stored as its block, its number of corners, and these corners' numbers in the
  /// block, clockwise, from 0.
  std::vector<int> cuts;
  std::vector<int> layer;   ///< (n) LAYER card that made it, from 1; 0: none
  Eigen::VectorXd area;     ///< [L^2] (n) at creation
  Eigen::VectorXd mass;     ///< [M] (n) > 0
  Eigen::VectorXd inertia;  ///< [M L^2] (n) about the centroid, RMOI
  /// [M L^2] (4, n) second moment of mass about the centroid at creation, the sum of
  /// mass times arm arm^T
  Eigen::Matrix4Xd second_moment;
  /// (n) inertial mass over mass during SOLVE with MSCALE, 1 for blocks that are not
  /// free; otherwise empty. Weights never have it.
  Eigen::VectorXd scale;
  Eigen::Matrix2Xd centroid;  ///< [L] (2, n) XC, YC
  Eigen::Matrix2Xd velocity;  ///< [L/T] (2, n) VX, VY
  /// (4, n) deformation gradient since creation: the present arm of a corner is
  /// gradient * arm. For a rigid block it is a rotation.
  Eigen::Matrix4Xd gradient;
  Eigen::VectorXd angle;   ///< rad (n) accumulated, for output
  Eigen::VectorXd spin;    ///< rad/T (n) TDOT
  Eigen::Matrix2Xd force;  ///< [F] (2, n) FX, FY of the last step, without gravity
  Eigen::VectorXd moment;  ///< [F L] (n) MOM of the last step
  /// [F/L^2] (4, n) applied stress (9), TAUA. Within a step, until blocks move, it
  /// holds the sums f_i x_j, [F L].
  Eigen::Matrix4Xd applied;
  Eigen::Matrix4Xd stress;       ///< [F/L^2] (4, n) internal stress (12), TAUI; 12 = 21
  Eigen::Matrix4Xd strain_rate;  ///< 1/T (4, n) (10), EDOT; 12 = 21

  int size() const { return static_cast<int>(material.size()); }
  int corners() const { return first_corner.back(); }
  int corners_of(int b) const { return first_corner[b + 1] - first_corner[b]; }
  bool is_free(int b) const { return fixity[b] == Fixity::free; }
  bool is_removed(int b) const { return fixity[b] == Fixity::removed; }
  bool is_driven(int b) const { return fixity[b] == Fixity::driven; }
  bool has_scaled_masses() const { return scale.size() > 0; }
  /// Returns the mass of block b times its scale: that which resists a force.
  double inertial_mass(int b) const {
    return has_scaled_masses() ? scale[b] * mass[b] : mass[b];
  }
  /// Returns whether two blocks can touch: at least one is free or driven.
  bool may_touch(int a, int b) const {
    return is_free(a) || is_free(b) || is_driven(a) || is_driven(b);
  }
  /// Returns the number of blocks that are not removed.
  int count_present() const;

  /// Returns the present vector from the centroid of the block to corner c, [L].
  Vec2 present_arm(int c) const {
    return corner.col(c) - centroid.col(corner_block[c]);
  }

  /// Returns the present outline of block b.
  geometry::Polygon outline(int b) const;

  /// Returns the present outlines of all blocks, (n). Those of removed blocks are
  /// empty.
  std::vector<geometry::Polygon> present_outlines() const;

  /// Appends blocks at rest. Throws std::invalid_argument if a corner is not finite, an
  /// area or a density is not positive, a block has more than geometry::max_corners
  /// corners, or joints and corners differ in number.
  void append(const std::vector<NewBlock>& blocks);

  /// Calls visit(block, corners) for each convex part in `cuts`; corners is a
  /// std::span<const int>.
  template <class Visit> void each_cut(const Visit& visit) const {
    for (std::size_t k = 0; k < cuts.size();
         k += 2 + static_cast<std::size_t>(cuts[k + 1]))
      visit(cuts[k],
            std::span(cuts).subspan(k + 2, static_cast<std::size_t>(cuts[k + 1])));
  }
  /// Adds the convex parts of this outline of block b, which is not convex, to `cuts`.
  void cut(int b, const geometry::Polygon& outline);

  /// Fixes block b: sets its velocity, spin and strain rates to zero
  /// (docs/theory.md#domain).
  void fix(int b, Fixity why);
};

}  // namespace blocks
