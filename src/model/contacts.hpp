// The active contacts (report 3.2, Appendix D).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <tuple>
#include <utility>

#include "model/blocks.hpp"
#include "model/law_state.hpp"

namespace blocks {

/// A corner in contact with an edge of another block, and the forces of the last step.
/// Potential contacts are working state of the step and not part of the model.
struct Contact {
  int corner = 0;               ///< corner that penetrates, NPC
  int edge = 0;                 ///< first corner of the edge, NPE
  double normal_elastic = 0.0;  ///< [F] FN of the spring alone, >= 0
  double shear_elastic = 0.0;   ///< [F] FS of the spring alone
  double normal_force = 0.0;    ///< [F] spring and dashpot, >= 0
  double shear_force = 0.0;     ///< [F] spring and dashpot
  double overlap = 0.0;         ///< [L] depth of the corner below the edge, >= 0
  bool operator==(const Contact&) const = default;
};

/// Returns the two blocks of a contact, the lower number first.
inline std::pair<int, int> pair_of(const Blocks& blocks, const Contact& contact) {
  const int a = blocks.corner_block[contact.corner];
  const int b = blocks.corner_block[contact.edge];
  return {std::min(a, b), std::max(a, b)};
}

/// Returns the key by which lists of contacts are sorted: pair of blocks, corner, edge.
/// All contacts of a list have different keys.
inline std::tuple<int, int, int, int> sort_key(const Blocks& blocks,
                                               const Contact& contact) {
  const auto [low, high] = pair_of(blocks, contact);
  return {low, high, contact.corner, contact.edge};
}

/// A corner that may touch a symmetry plane (SPLANE, docs/theory.md#symmetry-planes).
/// There is no friction. Lists are ordered by plane, then corner.
struct PlaneContact {
  int plane = 0;
  int corner = 0;
  bool active = false;
  double normal_elastic = 0.0;  ///< [F] FN of the spring alone, >= 0
  double normal_force = 0.0;    ///< [F] of the last step, spring and dashpot, >= 0
  double overlap = 0.0;         ///< [L] depth of the corner behind the plane, >= 0
  double offset = 0.0;          ///< [L] >= 0; also acts up to this gap
  bool operator==(const PlaneContact&) const = default;
};

}  // namespace blocks
