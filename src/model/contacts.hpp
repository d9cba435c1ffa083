// The list of potential contacts (report 3.2, Appendix D), as structure of arrays.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace blocks {

/// Records (corner, edge), ordered by pair of blocks (lower number first), then corner,
/// then edge, so that sums over the list do not depend on how it was found. k records.
struct Contacts {
  std::vector<int> corner;        ///< (k) corner that may penetrate, NPC
  std::vector<int> edge;          ///< (k) first corner of the edge, NPE
  std::vector<int> corner_block;  ///< (k) NBC
  std::vector<int> edge_block;    ///< (k)
  std::vector<char> active;       ///< (k) acted in the last step
  Eigen::ArrayXd normal_elastic;  ///< [F] (k) FN, spring only, >= 0
  Eigen::ArrayXd shear_elastic;   ///< [F] (k) FS, spring only
  Eigen::ArrayXd normal_force;    ///< [F] (k) with the dashpot, >= 0, last step
  Eigen::ArrayXd shear_force;     ///< [F] (k) with the dashpot, last step
  Eigen::ArrayXd overlap;         ///< [L] (k) depth of an active contact, else 0
  Eigen::ArrayXd damping;  ///< [F T/L] (k) C of (18); follows from masses and BETA

  int size() const { return static_cast<int>(corner.size()); }
  void resize(int k);
};

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
