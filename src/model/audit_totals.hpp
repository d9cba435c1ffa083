// What the audits of a run saw and found, for the summary.
#pragma once

#include <string>
#include <vector>

namespace blocks {

/// Two blocks that overlapped by more than their contacts explained, where it was
/// worst.
struct AuditedOverlap {
  int first = 0, second = 0;  ///< blocks, from 0
  long step = 0;
  double time = 0.0;       ///< [T]
  double depth = 0.0;      ///< [L] shortest shift that separates the two
  double explained = 0.0;  ///< [L] deepest acting contact or hidden axis
  double pressed = 0.0;    ///< [L] of its springs, FN / Kn
  double excess() const { return depth - explained; }
};

/// A contact that was deeper than the overlap of its two blocks, where it was worst.
struct AuditedContact {
  int block = 0, corner = 0;     ///< from 0, the corner in its block
  int edge_block = 0, edge = 0;  ///< likewise
  long step = 0;
  double time = 0.0;     ///< [T]
  double overlap = 0.0;  ///< [L] of the contact
  double common = 0.0;   ///< [L] of the blocks' intersection along its normal
  double pressed = 0.0;  ///< [L] of its spring, FN / Kn
  double excess() const { return overlap - common; }
};

struct AuditTotals {
  long every = 0;        ///< steps between audits
  long moments = 0;      ///< audits made
  long pairs = 0;        ///< pairs of blocks that the list had to hold, all moments
  long acting = 0;       ///< acting contacts
  long missed = 0;       ///< pairs of blocks that the list lacked
  long wrong = 0;        ///< pairs of blocks whose contacts were not the exact ones
  AuditedOverlap worst;  ///< of all pairs, a finding or not; excess() 0: none
  std::vector<AuditedOverlap> excess;  ///< findings, a pair once, the worst first
  AuditedContact deepest;              ///< a finding or not; excess() 0: none
  std::vector<AuditedContact> deep;    ///< findings, a contact once
  std::vector<std::string> faults;     ///< the missed and the wrong, in words
};

}  // namespace blocks
