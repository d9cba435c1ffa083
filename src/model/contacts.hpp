// The contacts that act (report 3.2, Appendix D).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "model/blocks.hpp"

namespace blocks {

/// A corner that acts on an edge of another block, and its forces in the last step.
/// What may act next is working state of the step, not of the model.
struct Contact {
  int corner = 0;               ///< corner that penetrates, NPC
  int edge = 0;                 ///< first corner of the edge, NPE
  double normal_elastic = 0.0;  ///< [F] FN, spring only, >= 0
  double shear_elastic = 0.0;   ///< [F] FS, spring only
  double normal_force = 0.0;    ///< [F] with the dashpot, >= 0
  double shear_force = 0.0;     ///< [F] with the dashpot
  double overlap = 0.0;         ///< [L] depth >= 0
  bool operator==(const Contact&) const = default;
};

/// The two blocks of a contact, the lower number first.
inline std::pair<int, int> pair_of(const Blocks& blocks, const Contact& contact) {
  const int a = blocks.corner_block[contact.corner];
  const int b = blocks.corner_block[contact.edge];
  return {std::min(a, b), std::max(a, b)};
}

/// Lists of contacts ascend in this key: pair of blocks, corner, edge. No two contacts
/// of a list have the same key.
inline std::tuple<int, int, int, int> sort_key(const Blocks& blocks,
                                               const Contact& contact) {
  const auto [low, high] = pair_of(blocks, contact);
  return {low, high, contact.corner, contact.edge};
}

/// Records (plane, corner), ordered by plane, then corner. Frictionless (SPLANE, rule
/// 21).
struct PlaneContacts {
  std::vector<int> plane;
  std::vector<int> corner;
  std::vector<char> active;
  Eigen::ArrayXd normal_elastic;  ///< [F]
  Eigen::ArrayXd normal_force;    ///< [F] last step
  Eigen::ArrayXd overlap;         ///< [L]

  int size() const { return static_cast<int>(corner.size()); }
  void resize(int k);
};

}  // namespace blocks
