// State of all blocks as structure of arrays (report Appendix D). n blocks, m corners.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

using geometry::Vec2;

/// Why a block does not move.
enum class Fixity : int { free = 0, by_user = 1, left_domain = 2 };

/// A block to be made from a simple clockwise outline.
struct NewBlock {
  geometry::Polygon outline;  ///< [L] clockwise
  int material = 0;
  double density = 0.0;  ///< [M/L^2] per unit thickness, > 0
  Fixity fixity = Fixity::free;
  int layer = 0;  ///< LAYER card that made it, from 1; 0: none
};

/// Second-order tensors are stored as rows 11, 12, 21, 22. Rotation anticlockwise
/// positive, tension positive, per unit thickness, any consistent set of units.
/// [F] force, [L] length, [T] time, [M] mass.
struct Blocks {
  // corners of block b: first_corner[b] .. first_corner[b + 1], clockwise
  std::vector<int> first_corner = {0};  ///< (n + 1)
  std::vector<int> corner_block;        ///< (m) block of each corner
  std::vector<int> next;                ///< (m) the corner after, clockwise, same block
  std::vector<int> previous;            ///< (m) the corner before, same block
  Eigen::Matrix2Xd arm;                 ///< [L] (2, m) corner - centroid, as made (13)
  Eigen::Matrix2Xd corner;              ///< [L] (2, m) centroid + gradient arm (15)

  std::vector<int> material;   ///< (n) the deck's material number, MAT
  std::vector<Fixity> fixity;  ///< (n) FIXED
  std::vector<char> convex;    ///< (n) 1: no corner turns inwards (exact, at creation)
  /// The convex parts of the blocks that are not convex, cut when the block is made:
  /// for each part its block, its number of corners, and where these are in the block,
  /// clockwise, from 0.
  std::vector<int> cuts;
  std::vector<int> layer;     ///< (n) which LAYER card made it, from 1; 0: none
  Eigen::VectorXd area;       ///< [L^2] (n) at creation
  Eigen::VectorXd mass;       ///< [M] (n) > 0
  Eigen::VectorXd inertia;    ///< [M L^2] (n) about the centroid, RMOI
  Eigen::Matrix2Xd centroid;  ///< [L] (2, n) XC, YC
  Eigen::Matrix2Xd velocity;  ///< [L/T] (2, n) VX, VY
  /// (4, n) deformation gradient since the block was made: the present arm of a corner
  /// is gradient * arm. Of a rigid block it is a rotation.
  Eigen::Matrix4Xd gradient;
  Eigen::VectorXd angle;     ///< rad (n) accumulated, for output
  Eigen::VectorXd spin;      ///< rad/T (n) TDOT
  Eigen::Matrix2Xd force;    ///< [F] (2, n) FX, FY of the last step, without gravity
  Eigen::VectorXd moment;    ///< [F L] (n) MOM of the last step
  Eigen::Matrix4Xd applied;  ///< [F/L^2] (4, n) applied stress (9), TAUA
  Eigen::Matrix4Xd stress;   ///< [F/L^2] (4, n) internal stress (12), TAUI; 12 = 21
  Eigen::Matrix4Xd strain_rate;  ///< 1/T (4, n) (10), EDOT; 12 = 21

  int size() const { return static_cast<int>(material.size()); }
  int corners() const { return first_corner.back(); }
  int corners_of(int b) const { return first_corner[b + 1] - first_corner[b]; }
  bool is_free(int b) const { return fixity[b] == Fixity::free; }

  /// The corner's place from the centroid of its block at present, [L].
  Vec2 present_arm(int c) const {
    return corner.col(c) - centroid.col(corner_block[c]);
  }

  /// The outline of block b as it is at present.
  geometry::Polygon outline(int b) const;

  /// Appends blocks at rest. Throws std::invalid_argument when a corner is not finite,
  /// an area or density is not positive or a block has more than
  /// geometry::most_corners.
  void append(const std::vector<NewBlock>& blocks);

  /// Calls visit(block, corners) for the convex parts in `cuts`; corners are a
  /// std::span<const int>.
  template <class Visit> void each_cut(const Visit& visit) const {
    for (std::size_t k = 0; k < cuts.size();
         k += 2 + static_cast<std::size_t>(cuts[k + 1]))
      visit(cuts[k],
            std::span(cuts).subspan(k + 2, static_cast<std::size_t>(cuts[k + 1])));
  }
  /// Adds the cuts of block b, which is not convex, for this outline.
  void cut(int b, const geometry::Polygon& outline);

  /// Stops block b for good: velocities, spin and strain rates zero
  /// (docs/theory.md#domain).
  void fix(int b, Fixity why);
};

}  // namespace blocks
