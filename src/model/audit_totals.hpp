// Counts and findings of the audits of a run, for the summary.
#pragma once

#include <string>
#include <vector>

namespace blocks {

/// Two blocks that overlapped by more than their contacts explain, at the audit where
/// the excess was largest.
struct AuditedOverlap {
  int first = 0, second = 0;  ///< blocks, from 0
  long step = 0;
  double time = 0.0;       ///< [T]
  double depth = 0.0;      ///< [L] shortest translation that separates them
  double explained = 0.0;  ///< [L] deepest active contact or hidden axis
  double pressed = 0.0;    ///< [L] compression of its springs, FN / Kn
  double excess() const { return depth - explained; }
};

/// A contact that was deeper than the overlap of its two blocks, at the audit where the
/// excess was largest.
struct AuditedContact {
  int block = 0, corner = 0;     ///< block from 0, corner in that block from 0
  int edge_block = 0, edge = 0;  ///< likewise for the edge
  long step = 0;
  double time = 0.0;     ///< [T]
  double overlap = 0.0;  ///< [L] of the contact
  double common = 0.0;   ///< [L] depth of the intersection along its normal
  double pressed = 0.0;  ///< [L] compression of its spring, FN / Kn
  double excess() const { return overlap - common; }
};

/// A corner behind a symmetry plane, at the audit where it was deepest.
struct AuditedPlane {
  int plane = 0, block = 0, corner = 0;  ///< from 0, corner in that block
  long step = 0;
  double time = 0.0;     ///< [T]
  double depth = 0.0;    ///< [L]
  double pressed = 0.0;  ///< [L] compression of its spring, FN / Kn
};

/// A block whose force of water is not exact, at the audit where the error was largest.
struct AuditedWater {
  int block = 0;  ///< from 0
  long step = 0;
  double time = 0.0;    ///< [T]
  double share = 0.0;   ///< error of the force, of gamma times the area of the block
  bool tested = false;  ///< false: no block was judged
};

/// Totals over all audits of a run.
struct AuditTotals {
  long every = 0;    ///< steps between audits
  long moments = 0;  ///< number of audits
  long pairs = 0;    ///< pairs of blocks that the list must hold, over all audits
  long acting = 0;   ///< active contacts
  long missed = 0;   ///< pairs of blocks missing from the list
  long wrong = 0;    ///< pairs of blocks whose contacts differed from the exact ones
  long wrong_at_planes = 0;  ///< corners that wrongly act on a plane, or do not
  long late = 0;  ///< pairs of blocks whose kept decision is no longer the exact one
  AuditedOverlap worst;  ///< of all pairs, even if no finding; excess() 0: none
  std::vector<AuditedOverlap> excess;  ///< findings, one per pair, the worst first
  AuditedContact deepest;              ///< even if no finding; excess() 0: none
  std::vector<AuditedContact> deep;    ///< findings, one per contact
  AuditedPlane behind;                 ///< depth 0: there is none
  AuditedWater water;
  std::vector<std::string> faults;  ///< wrong pairs, missed pairs and planes, in words
};

}  // namespace blocks
