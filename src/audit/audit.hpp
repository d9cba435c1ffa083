// Audits one moment of a run (docs/audit.md). The audit checks that the program's list
// of near pairs is complete, that its decisions are exact, and that contacts explain
// how deep blocks overlap.
#pragma once

#include <utility>
#include <vector>

#include "audit/exact_pair_rule.hpp"
#include "model/model.hpp"

namespace blocks::audit {

/// Two blocks, the lower number first.
using BlockPair = std::pair<int, int>;

/// Two blocks whose acting contacts differ from the exact ones.
struct WrongPair {
  int first = 0, second = 0;  ///< first < second
  /// Corner and edge of each contact, in ascending order.
  std::vector<std::pair<int, int>> acting, exact;
};

/// Two blocks that overlap by more than the contacts between them explain.
struct ExcessOverlap {
  int first = 0, second = 0;  ///< first < second
  double depth = 0.0;         ///< [L] length of the shortest shift that separates them
  double explained = 0.0;  ///< [L] depth of the deepest acting contact or hidden axis
  /// [L] The largest compression FN / Kn of the springs between them.
  double pressed = 0.0;
  double area = 0.0;  ///< [L^2] of the overlap
  Vec2 place = Vec2::Zero();
  double excess() const { return depth - explained; }
};

/// A contact that is deeper than the overlap of its two blocks along its normal.
struct DeepContact {
  int corner = 0, edge = 0;
  double overlap = 0.0;  ///< [L] depth of the contact
  /// [L] Extent of the intersection of the two blocks along the normal of the edge.
  double common = 0.0;
  double pressed = 0.0;  ///< [L] compression FN / Kn of its spring
  double excess() const { return overlap - common; }
};

/// A corner whose contact with a symmetry plane is wrong.
struct PlaneFault {
  int plane = 0, corner = 0;
  bool acts = false;  ///< false: it is behind the plane, but does not act
};

/// A block whose force of water is not exact.
struct WaterError {
  int block = -1;      ///< -1: none is judged
  double share = 0.0;  ///< error of the force, of gamma times the area of the block
};

/// A corner behind a symmetry plane.
struct BehindPlane {
  int plane = 0, corner = 0;
  double depth = 0.0;    ///< [L]
  double pressed = 0.0;  ///< [L] compression FN / Kn of its spring
};

/// The extent and the findings of one audit.
struct Findings {
  long pairs = 0;                 ///< pairs of blocks that the list must contain
  long acting = 0;                ///< acting contacts
  std::vector<BlockPair> missed;  ///< pairs that the list lacks
  std::vector<WrongPair> wrong;
  std::vector<PlaneFault> wrong_at_planes;
  BehindPlane behind;  ///< the deepest corner behind a plane; depth 0: there is none
  WaterError water;    ///< the largest error of a force of water
  long late = 0;  ///< pairs whose kept decision was exact when it was made, but not now
  std::vector<ExcessOverlap> excess;  ///< the worst first
  /// The worst of all pairs, even if it is no finding. If there is none, excess() is 0.
  ExcessOverlap worst;
  std::vector<DeepContact> deep;  ///< the worst first
  /// The worst of all contacts, even if it is no finding. If there is none, excess() is
  /// 0.
  DeepContact deepest;

  /// Returns whether the list of near pairs is complete and all decisions are exact.
  bool sound() const {
    return missed.empty() && wrong.empty() && wrong_at_planes.empty();
  }
};

/// A contact that the law of a joint holds, so that it acts outside the contact rule
/// (docs/laws.md#results): it is bonded, or dilation keeps its spring
/// pressed in.
struct HeldContact {
  int corner = 0, edge = 0;
  bool bonded = false;
  double offset = 0.0;  ///< [L] added to its overlap
  bool failed =
      false;  ///< weakened, if bonded: it ends where its corner leaves the edge
};

/// Returns the contacts of a model that the laws of joints hold. The list of contacts
/// must be up to date.
std::vector<HeldContact> held_contacts(const Model& model);

/// The state in which a step decided its contacts, and the contacts that acted. Blocks
/// and corners are numbered as in `blocks`.
struct Moment {
  const Blocks& blocks;                  ///< before the step moved them
  const std::vector<Contact>& contacts;  ///< the contacts that acted in the step
  const Settings& settings;
  double left = 0.0;  ///< [L] how far corners may move before the next search
  std::vector<BlockPair> listed;  ///< the program's near pairs, in ascending order
  std::vector<int> order = {};    ///< order in which the program steps (Model::order)
  std::vector<HeldContact> held = {};  ///< of the state before the step
  /// States of the laws of joints after the step, parallel to `contacts`, or empty.
  std::vector<LawState> law_states = {};
  /// The decisions that the step made or kept, in the numbers of the steps.
  KeptDecisions kept = {};
  std::vector<PlaneContact> plane_contacts = {};  ///< after the step
  Water water = {};
  double time = 0.0;  ///< [T] of the forces
};

/// Audits all pairs of blocks that are near each other.
/// Held contacts act besides those of the rule, or instead of them: a corner that is
/// bonded to a block acts on no other edge of that block.
/// The decision of a pair that is kept from an earlier step is judged where the blocks
/// were then.
/// A pair is missed if the list lacks it although the bounding boxes of its blocks may
/// meet before the next search.
/// Two blocks overlap in excess if they overlap deeper than their deepest acting
/// contact and than the axes that third parts hide. A contact is too deep if its
/// depth exceeds the extent of the exact intersection of its two blocks along its
/// normal. Both have a tolerance of explained_slack times the shortest edge of the two
/// blocks. Contacts that are less deep than the tolerance are not tested.
Findings audit(const Moment& moment);

/// Tolerance of depths, as a fraction of a block's shortest edge. A smaller overlap
/// needs no contact, and a smaller contact needs no overlap. In decks at rest and in
/// motion the excess is round-off; an excess above this bound is not.
constexpr double explained_slack = 0.001;

}  // namespace blocks::audit
