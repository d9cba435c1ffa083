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

/// Splits the list into its groups, all awake.
void group_contacts(const Contacts& contacts, std::vector<ContactGroup>& groups);

/// Relative motion that certainly passes before a corner now outside a convex block
/// gets inside again, [L], or 0. Seen from the block's centroid, corners move by at
/// most the relative motion u. The corner stands a gap g outside an edge's line,
/// opposite to the point (1 - q) p1 + q p2 of that line, which moves by f = |1 - q| +
/// |q| times u at most. While u (1 + f) <= 0.8 g and the edge turns by less than 0.4
/// rad (u <= 0.2 L), the corner stays outside by more than the slack.
double travel_before_contact(const Blocks& blocks, int corner, int block);

/// Relative motion during which deciding the group again certainly gives the same
/// acting record (or none, -1), [L], or 0 where the decision hangs by little. Sound, so
/// that results do not depend on it:
///
/// - Differences of two points change by the relative motion u at most, so a product
///   (scalar or vector) of two differences of lengths r and s changes by u (r + s) +
///   u^2. Being at most r s, it keeps its sign while u is below |product| / (1.5 (r +
///   s)), with a fifth of it to spare for the slack and round-off.
/// - A depth below an edge of length L changes by u + 2 u w / L at most, w the distance
///   from the edge's first corner.
/// - The acting record stays admissible and penetrated; every other one stays
///   inadmissible or deeper. Without an acting record all stay inadmissible, or the
///   corner stays outside.
double certain_travel(const Blocks& blocks, const Contacts& contacts,
                      const ContactGroup& group);

}  // namespace blocks::dynamics
