// Inputs for the contact predicates, in families of what is hard for them; each case
// again from its family and number.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec2.hpp"

namespace blocks::robustness {

using geometry::Vec2;

/// A corner with a tangent, an edge, a second edge and the centroid of the edge's
/// block. Coordinates are finite, p1 and p2 differ, and so do q1 and q2.
struct ContactCase {
  Vec2 c, p1, p2, q1, q2, centroid, neighbour;
};

struct ContactFamily {
  const char* name;
  int weight;  ///< parts of 100 of all cases
  ContactCase (*make)(std::uint64_t number);
};

inline constexpr std::size_t contact_family_count = 11;
const std::array<ContactFamily, contact_family_count>& contact_families();

}  // namespace blocks::robustness
