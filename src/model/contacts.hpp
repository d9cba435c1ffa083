// The active contacts (report 3.2, Appendix D).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "model/blocks.hpp"
#include "model/joint_state.hpp"

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

/// Potential contacts between corners and symmetry planes, as arrays ordered by plane,
/// then corner. They are frictionless (SPLANE, docs/theory.md#symmetry-planes).
struct PlaneContacts {
  std::vector<int> plane;
  std::vector<int> corner;
  std::vector<char> active;
  Eigen::ArrayXd normal_elastic;  ///< [F]
  Eigen::ArrayXd normal_force;    ///< [F] of the last step
  Eigen::ArrayXd overlap;         ///< [L]

  int size() const { return static_cast<int>(corner.size()); }
  void resize(int k);
};

}  // namespace blocks
