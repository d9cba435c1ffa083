// The forces that a stress field puts on the faces of two blocks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/preparation/faces.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Two corners at an end of a face are one point if their distance is less than this
/// fraction of the side. It exceeds the rounding of coordinates up to a million block
/// sizes. A larger value makes the moment of a face wrong by up to that fraction.
inline constexpr double same_point = 1e-9;

/// The forces of a contact: those of all faces that it belongs to.
struct FaceLoad {
  CornerOnEdge at;
  double normal = 0.0, shear = 0.0;  ///< [F]
};

/// Unit vectors along an edge and outwards.
struct EdgeFrame {
  Vec2 along, outwards;
  EdgeFrame(const Blocks& blocks, int edge);
};

/// Returns the force of a listed contact on the block of its corner, [F]. The opposite
/// force acts at the same point on the block of its edge.
Vec2 force_on_corner(const Blocks& blocks, const Contact& contact);

/// Returns the force of a plane on the block of a corner, [F].
Vec2 force_on_corner(const Plane& plane, const PlaneContact& contact);

/// The forces on the faces of two blocks, contact by contact. Refers to the blocks and
/// the field.
class PairLoads {
 public:
  PairLoads(const Blocks& blocks, const StressField& field)
      : blocks_(blocks), field_(field) {}

  void clear() { all_.clear(); }
  const std::vector<FaceLoad>& all() const { return all_; }

  /// Adds the forces of a flush face of length L. The traction is linear along it, from
  /// p1 at one end to p2 at the other. Two forces replace it: L (2 p1 + p2) / 6 at the
  /// first end and L (p1 + 2 p2) / 6 at the second. Their sum and moment are the same.
  void add(const Face& face);

 private:
  void add(const CornerOnEdge& at, const Eigen::Matrix2d& force);

  const Blocks& blocks_;
  const StressField& field_;
  std::vector<FaceLoad> all_;
};

}  // namespace blocks::dynamics
