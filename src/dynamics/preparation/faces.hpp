// Faces: pairs of flush sides of two blocks, and the contacts at their ends. BOND and
// INSITU act on them.
#pragma once

#include <array>

#include "dynamics/rules/pair_rule.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// One of the two ends of a face: the contacts there, at most two.
struct FaceEnd {
  std::array<CornerOnEdge, 2> records;
  int count = 0;
  double gap = 0.0;  ///< [L] distance of the two sides
};

/// The two sides of a face: e of one block, f of another, in opposite directions. A
/// side is named by its first corner. Refers to the blocks.
class Face {
 public:
  Face(const Blocks& blocks, int e, int f);

  /// Returns whether the two sides are flush: they face each other (within 18 degrees)
  /// and are at most `tolerance` [L] apart at both ends of their common part. That part
  /// must be longer than `min` [L].
  bool is_flush(double tolerance, double min) const;
  /// Returns the distance along the face within which two corners share an end, [L].
  /// is_flush() and BOND use it. INSITU loads ends with `same_point` (face_loads.hpp).
  double slack(double tolerance) const;
  /// Returns the end of the face that is nearer to the end of e, or to its start. It
  /// has two contacts if its two corners are at most `slack` [L] apart along the face.
  FaceEnd end(bool at_end_of_e, double slack) const;
  double length_of_side() const { return length_; }  ///< [L] of e
  /// Returns the length of the common part of the two sides, [L].
  double common() const { return high() - low(); }

 private:
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  double position(int corner) const { return along_.dot(at(corner) - start_); }
  double low() const;
  double high() const;
  double depth(int corner, int edge) const;

  const Blocks& blocks_;
  int e_, f_;
  Vec2 start_, along_;
  double length_;
};

/// Returns the depth of a corner below an edge, [L]; negative: a gap.
double depth_below(const Blocks& blocks, const CornerOnEdge& at);

/// Calls visit(face) for each side of block a with each side of block b.
template <class Visit>
void each_face(const Blocks& blocks, int a, int b, const Visit& visit) {
  for (int e = blocks.first_corner[a]; e < blocks.first_corner[a + 1]; ++e)
    for (int f = blocks.first_corner[b]; f < blocks.first_corner[b + 1]; ++f)
      visit(Face(blocks, e, f));
}

}  // namespace blocks::dynamics
