// How neighbouring blocks meet: corners inside edges of others, and slits too narrow to
// be meant. A report for the user; knows nothing of contacts.
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// A corner of one block inside an edge of another, up to rounding_units. Legal: layers
/// with joints out of line have them, a conforming mesh has none.
struct TJunction {
  int block = 0;  ///< whose corner, from 0
  int corner = 0;
  int other = 0;  ///< whose edge, from 0
  Vec2 place = Vec2::Zero();
};

/// Two blocks that nearly touch along facing edges, with no third block between them.
struct Slit {
  int first = 0, second = 0;  ///< blocks from 0, first < second
  double width = 0.0;         ///< [L] > 0: the largest along the common length
  Vec2 place = Vec2::Zero();  ///< the corner where it is so wide
  bool by_rounding = false;   ///< no wider than rounding of the two makes it
};

struct Joints {
  std::vector<TJunction> t_junctions;
  std::vector<Slit> slits;  ///< in order of (first, second)
};

/// A slit is at most this wide, in square roots of the smaller block's area.
constexpr double widest_slit = 1e-2;

/// How the blocks meet. outlines: simple and clockwise, [L]. Exact: whether facing
/// edges touch or leave a slit, be it of an ulp. Edges with no more in common than
/// `widest_slit` have none. n log n for blocks of like size.
Joints find_joints(const std::vector<Polygon>& outlines);

}  // namespace blocks::geometry
