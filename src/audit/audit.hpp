// Judges the contacts of one moment: is the list complete, is every decision the exact
// one, do blocks overlap more than their contacts explain (docs/audit.md)?
#pragma once

#include <vector>

#include "audit/exact_decision.hpp"
#include "model/contacts.hpp"
#include "model/settings.hpp"

namespace blocks::audit {

/// A corner and an edge that the list ought to hold.
struct MissedPair {
  int corner = 0, edge = 0;
  double overlap = 0.0;  ///< [L] below zero: outside of the edge's line
  bool acts = false;     ///< the exact decision is that it acts
};

/// The edge of the block that acts on the corner is not the exact one. -1: none.
struct WrongDecision {
  int corner = 0, block = 0, acting = -1, exact = -1;
};

/// Two blocks that overlap by more than the contacts between them explain.
struct ExcessOverlap {
  int first = 0, second = 0;  ///< first < second
  double depth = 0.0;         ///< [L] shortest shift that separates the two
  double explained = 0.0;     ///< [L] deepest acting contact, or toe at a joint
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
  long pairs = 0;    ///< corners near a block, looked at one by one
  long records = 0;  ///< corners and edges the list ought to hold
  long acting = 0;   ///< acting contacts
  long hanging = 0;  ///< decisions that hang by the rounding of the shield's question
  std::vector<MissedPair> missed;
  std::vector<WrongDecision> wrong;
  std::vector<ExcessOverlap> excess;
  ExcessOverlap worst;  ///< of all pairs, a finding or not; excess() 0: none
  std::vector<DeepContact> deep;
  DeepContact deepest;  ///< a finding or not; excess() 0: none

  bool sound() const { return missed.empty() && wrong.empty(); }
};

/// The state in which a step decided its contacts, and what it decided.
struct Moment {
  const Blocks& blocks;      ///< before they moved
  const Contacts& contacts;  ///< after the step: which records acted
  const Settings& settings;
  double left = 0.0;  ///< [L] so far corners may still go before the next list
};

/// All corners against all blocks near them, by a sweep. A pair is missed when the list
/// does not hold it though the edge is admitted for the corner, or the corner as near
/// to the edge as what is left of the list's promise: twice what corners may
/// still go. An
/// overlap is in excess when it goes beyond the deepest acting contact of
/// the two blocks by more than explained_slack of the shortest edge of either. A
/// contact is too deep when it goes beyond the extent, along its normal, of the exact
/// intersection of its two blocks by more than that; shallower ones are not asked.
Findings audit(const Moment& moment);

/// Part of a block's shortest edge below which an overlap needs no contact of its own,
/// and a contact no overlap.
/// In decks at rest and in motion the excess is round-off; beyond this bound it is
/// real.
constexpr double explained_slack = 0.001;

}  // namespace blocks::audit
