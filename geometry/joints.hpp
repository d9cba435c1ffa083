// Finds how neighbouring blocks meet: corners inside edges of other blocks, and slits
// too narrow to be intended. A report for the user, independent of contacts.
#pragma once

#include <vector>

#include "geometry/step_progress.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// A corner of one block inside an edge of another, up to rounding_units. T-junctions
/// are legal: layers with staggered joints have them. A conforming mesh has none.
struct TJunction {
  int block = 0;  ///< block that has the corner, from 0
  int corner = 0;
  int other = 0;  ///< block that has the edge, from 0
  Vec2 place = Vec2::Zero();
};

/// Two blocks that nearly touch along edges that run against each other (their angle
/// exceeds 90 degrees), with no other block between them.
struct Slit {
  int first = 0, second = 0;  ///< blocks from 0, first < second
  double width = 0.0;         ///< [L] > 0: largest width along the common length
  Vec2 place = Vec2::Zero();  ///< corner where the slit has this width
  bool by_rounding = false;   ///< rounding of the corners explains the width
};

struct Joints {
  std::vector<TJunction> t_junctions;
  std::vector<Slit> slits;  ///< in order of (first, second)
};

/// The largest width of a slit, as a multiple of the square root of the smaller block's
/// area. Wider gaps are taken as intended.
constexpr double widest_slit = 1e-2;

/// Finds T-junctions and slits. outlines: simple and clockwise, [L]. Whether such
/// edges touch or leave a slit is decided exactly, so slits of one ulp are found. Edges
/// form no slit if their common length is at most the width of the widest slit. Takes
/// O(n log n) time for n blocks of similar size. A report of progress may throw.
Joints find_joints(const std::vector<Polygon>& outlines,
                   StepProgress* progress = nullptr);

}  // namespace blocks::geometry
