// Judges the contacts of one moment (docs/audit.md): whether the program's list of near
// pairs is complete, whether its decisions are exact, and whether contacts explain how
// deep blocks are in each other.
#pragma once

#include <utility>
#include <vector>

#include "audit/exact_pair_rule.hpp"
#include "model/contacts.hpp"
#include "model/settings.hpp"

namespace blocks::audit {

/// Two blocks, the lower number first.
using BlockPair = std::pair<int, int>;

/// The contacts that act between two blocks are not the exact ones.
struct WrongPair {
  int first = 0, second = 0;  ///< first < second
  /// Corner and edge of each contact, in ascending order.
  std::vector<std::pair<int, int>> acting, exact;
};

/// Two blocks that overlap by more than the contacts between them explain.
struct ExcessOverlap {
  int first = 0, second = 0;  ///< first < second
  double depth = 0.0;         ///< [L] shortest shift that separates the two
  double explained = 0.0;     ///< [L] deepest acting contact or hidden axis
  double pressed = 0.0;       ///< [L] of its springs, FN / Kn, the largest
  double area = 0.0;          ///< [L^2] of the overlap
  Vec2 place = Vec2::Zero();
  double excess() const { return depth - explained; }
};

/// A contact that acts at a depth which the overlap of its two blocks does not have.
struct DeepContact {
  int corner = 0, edge = 0;
  double overlap = 0.0;  ///< [L] of the contact
  double common = 0.0;   ///< [L] of the blocks' intersection along the edge's normal
  double pressed = 0.0;  ///< [L] of its spring, FN / Kn
  double excess() const { return overlap - common; }
};

/// What one audit saw and found.
struct Findings {
  long pairs = 0;                 ///< pairs of blocks that the list has to hold
  long acting = 0;                ///< acting contacts
  std::vector<BlockPair> missed;  ///< pairs that the list lacks
  std::vector<WrongPair> wrong;
  std::vector<ExcessOverlap> excess;  ///< the worst first
  ExcessOverlap worst;            ///< of all pairs, a finding or not; excess() 0: none
  std::vector<DeepContact> deep;  ///< the worst first
  DeepContact deepest;            ///< a finding or not; excess() 0: none

  bool sound() const { return missed.empty() && wrong.empty(); }
};

/// The state in which a step decided its contacts, and what it decided. All numbers of
/// blocks and corners are those of `blocks`.
struct Moment {
  const Blocks& blocks;                  ///< before they moved
  const std::vector<Contact>& contacts;  ///< after the step: those that acted
  const Settings& settings;
  double left = 0.0;  ///< [L] how far corners may still go before the next list
  std::vector<BlockPair> listed;  ///< the program's near pairs, in ascending order
  std::vector<int> order = {};    ///< in which the program steps (Model::order)
};

/// Looks at all pairs of blocks near each other. A pair is missed if the list lacks it
/// although the bounding boxes of its blocks may meet before the next list. An overlap
/// is in excess if it is deeper than the deepest acting contact of the two blocks, and
/// than the axes that closed joints hide, by more than explained_slack of the shortest
/// edge of either block. A contact is too deep if it is deeper by more than that than
/// the exact intersection of its two blocks is thick along its normal; shallower
/// contacts are not tested.
Findings audit(const Moment& moment);

/// Part of a block's shortest edge below which an overlap needs no contact of its own,
/// and a contact needs no overlap. In decks at rest and in motion the excess is
/// round-off; beyond this bound it is real.
constexpr double explained_slack = 0.001;

}  // namespace blocks::audit
