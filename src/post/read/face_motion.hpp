// Opening and shear displacement of faces: how two blocks have moved there since the
// first frame (docs/joints.md#opening).
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "post/read/crack_tracker.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// A part of side `side` of block `block`, both from 0. Its ends are shares of the
/// side, 0 at its first corner and 1 at its last one.
struct SidePart {
  int block = 0;
  std::size_t side = 0;
  Eigen::Vector2d ends{0, 1};
  /// Returns end `end`, 0 or 1, where the block is in a frame [L].
  Eigen::Vector2d at(const Frame& frame, int end) const;
  /// Returns the vector from the first corner of the side to the last one [L].
  Eigen::Vector2d along(const Frame& frame) const;
};

/// The parts of sides of two blocks that lie on each other in the first frame. End 0 of
/// `other` is where end 0 of `own` is, and the same holds for end 1.
struct Face {
  SidePart own, other;
  Eigen::Matrix2d first;  ///< opening and shear (rows) of both ends there [L]
};

/// What has become of a face. Opening is positive if the blocks have moved apart. Shear
/// is positive if, seen from one block, the other one has moved to the right (dextral).
struct FaceMotion {
  std::array<Eigen::Vector2d, 2> own, other;  ///< [L] the ends of its two sides now
  Eigen::Vector2d opening, shear;             ///< [L] at both ends; linear between them
};

/// Returns the faces of the first frame, in the order of x. Their sides are at most a
/// hundredth of the shorter side apart, and have at least as much in common.
/// later: blocks that have none, because they were made later.
std::vector<Face> find_faces(const Frame& first, const std::vector<char>& later);

/// Returns the motion of a face; none if a block is removed, the sides have turned away
/// from each other by more than 18 degrees, or they have moved apart or along each
/// other by more than the length of the face.
std::optional<FaceMotion> motion_of(const Face& face, const Frame& now);

/// Returns the motions of all faces of a frame. first: where its blocks were
/// (CrackedBlocks::first). cracked: null if cracks are not known.
std::vector<FaceMotion> face_motions(const Frame& now, const Frame& first,
                                     const CrackedBlocks* cracked);

}  // namespace blocks::post
