// The contacts that act (report 3.2, Appendix D), as structure of arrays.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace blocks {

/// The forces of a contact.
struct ActingContact {
  int record = 0;               ///< index in the list
  double normal_elastic = 0.0;  ///< [F] FN, spring only, >= 0
  double shear_elastic = 0.0;   ///< [F] FS, spring only
  double normal_force = 0.0;    ///< [F] with the dashpot, >= 0, last step
  double shear_force = 0.0;     ///< [F] with the dashpot, last step
  double overlap = 0.0;         ///< [L] depth >= 0
  bool operator==(const ActingContact&) const = default;
};

/// Contacts (corner, edge) of the last step, ordered by pair of blocks (lower number
/// first), then corner, then edge. Of k contacts those that are not active have ended;
/// a step lists active ones only. What may act next is working state of the step
/// (dynamics/pair_contacts.hpp).
struct Contacts {
  std::vector<int> corner;            ///< (k) corner that penetrates, NPC
  std::vector<int> edge;              ///< (k) first corner of the edge, NPE
  std::vector<bool> active;           ///< (k) acted in the last step
  std::vector<ActingContact> acting;  ///< of the active ones, in the order of the list

  int size() const { return static_cast<int>(corner.size()); }
  /// So many records; none acts.
  void resize(int k);
  /// Forces and overlap of record i: all 0 where it does not act.
  ActingContact at(int i) const;
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
