// Records of one corner against the edges of one block, which are decided together
// (rule 12), and for how long such a decision stands.
#pragma once

#include <cmath>
#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

/// Records first .. last - 1 of the contact list. Working state: not part of the model,
/// and without influence on results.
struct ContactGroup {
  int first = 0, last = 0;
  int corner_block = 0, edge_block = 0;
  int acting = -1;  ///< the record that acts, -1: none, as last decided
  /// The edges' block is not convex: the group after this one holds the same records,
  /// for the second edge of a notch.
  bool reentrant = false, of_notch = false;
  /// The decision stands while the blocks have moved against each other by less than
  /// `certain` [L] (0: decide now) since they had this offset and had swung by this.
  double certain = 0.0;
  double offset_x = 0.0, offset_y = 0.0;  ///< [L] between the centroids
  double swing = 0.0;                     ///< [L] of both blocks together
  int hopeless = 0;  ///< decisions left for which certainty is not even tried
  // of the acting record in this step
  double tangent_x = 0.0, tangent_y = 0.0;  ///< unit vector along the edge
  double overlap = 0.0;                     ///< [L]
};

/// Elastic force that a record held when it ceased to act.
struct LostForce {
  int group, record;
  double normal, shear;  ///< [F] FN > 0, FS
};

/// How far each block has turned and strained about its centroid: the sum over the
/// steps of the largest change of an arm (|dx| + |dy|), [L].
using Swing = std::vector<double>;

/// Bound on how far the two blocks of a group have moved against each other since it
/// was decided: no difference of two of their corners, or of a corner and a centroid,
/// has changed by more, [L].
inline double relative_motion(const Blocks& blocks, const Swing& swing,
                              const ContactGroup& g) {
  const int a = g.corner_block, b = g.edge_block;
  const double x = blocks.centroid(0, a) - blocks.centroid(0, b);
  const double y = blocks.centroid(1, a) - blocks.centroid(1, b);
  return std::abs(x - g.offset_x) + std::abs(y - g.offset_y) +
         2.0 * (swing[a] + swing[b] - g.swing);
}

/// Starts to measure relative_motion from here.
void mark_position(const Blocks& blocks, const Swing& swing, ContactGroup& group);

/// The groups of a list, and what passes between them. Working state between searches:
/// not part of the model, and without influence on results.
struct ContactGroups {
  std::vector<ContactGroup> all;  ///< in the order of the list
  std::vector<int> by_corner;     ///< indices into `all`, corner after corner
  std::vector<int>
      first_of_corner;          ///< (corners + 1) where a corner's begin in by_corner
  std::vector<LostForce> lost;  ///< in this step
  Swing swing;                  ///< of the blocks since the groups were made
};

/// Splits the list into its groups, all awake. each_alone: one record each, for studies
/// without the nearest edge.
void group_contacts(const Blocks& blocks, const Contacts& contacts,
                    ContactGroups& groups, bool each_alone = false);

}  // namespace blocks::dynamics
