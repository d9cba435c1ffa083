#include "dynamics/decisions/certain_decisions.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/kernels/kernels.hpp"

namespace blocks::dynamics {
namespace {

/// Adds the kernel's answer about two parts to the decision of their blocks.
class LaneDecision {
 public:
  LaneDecision(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
               const Decisions& decisions, int p, const FacingAnswers& answers,
               int lane, const int* part, JointScratch& scratch, double dt)
      : blocks_(blocks), index_(index), parts_(parts),
        longest_(decisions.bounds.longest), rounding_(decisions.bounds.rounding),
        answers_(answers), lane_(lane), scratch_(scratch),
        own_(part[answers.own[lane] > 0.0]), other_(part[answers.own[lane] <= 0.0]),
        side_(static_cast<int>(answers.side[lane])),
        facing_(static_cast<int>(answers.facing[lane])),
        corner_(static_cast<int>(answers.corner[lane])), pair_(index.pairs[p]),
        dt_(dt) {}

  void take(CertainDecision& decision) {
    const double apart = answers_.apart[lane_];
    room_ = answers_.faces[lane_];
    // Parts that are near get their contacts before they touch. So "apart" is preferred
    // only if it holds for more than a quarter of the other room.
    if (apart > 0.0 && apart > 0.25 * room_) {
      decision.room = std::min(decision.room, apart);
      return;
    }
    if (!(room_ > 0.0) || !sides_are_isolated() || !joints_are_open()) {
      decision.room = 0.0;
      return;
    }
    add_contacts(decision.contacts);
    decision.room = std::min(decision.room, room_);
    decision.room_of_neighbours =
        std::min(decision.room_of_neighbours, room_of_neighbours_);
  }

 private:
  bool sides_are_isolated() const {
    return parts_.is_isolated(own_, side_) &&
           (facing_ < 0 || parts_.is_isolated(other_, facing_));
  }
  int before(int part, int k) const { return (k > 0 ? k : parts_.corners(part)) - 1; }
  bool joints_are_open() {
    return is_open(0, {own_, side_, true, other_}) &&
           is_open(1, {own_, side_, false, other_}) &&
           is_open(2, {other_, facing_ < 0 ? corner_ : facing_, true, own_}) &&
           is_open(3, {other_, facing_ < 0 ? before(other_, corner_) : facing_, false,
                       own_});
  }
  /// Returns whether a joint is open: the centroid of the other part is inside its
  /// surface, or neighbours do not cover its side. If its side is an inner side, it is
  /// in doubt. May reduce the rooms.
  bool is_open(int k, const SideOfJoint& joint) {
    if (parts_.is_inner(blocks_, parts_.side(joint.part, joint.side)))
      return false;
    const bool is_convex =
        blocks_.convex[parts_.block(own_)] && blocks_.convex[parts_.block(other_)];
    const double inside = is_convex ? answers_.joint[k][lane_] : 0.0;
    if (inside > 0.25 * room_) {
      room_ = std::min(room_, inside);
      return true;
    }
    const double part_of_size =
        0x1p-5 * std::min(longest_[pair_.low], longest_[pair_.high]);
    const double few_steps = 8.0 * (way_of_step(pair_.low) + way_of_step(pair_.high));
    const double rounding = answers_.rounding[lane_] + rounding_;
    for (const double room : {room_, 0x1p-4 * room_, few_steps}) {
      const double of_neighbours =
          room == few_steps ? room : std::max(room, part_of_size);
      if (!(room > 0.0) || room > room_ ||
          !is_surely_uncovered(blocks_, parts_, Neighbours{index_}, joint,
                               room + rounding, of_neighbours + rounding, scratch_))
        continue;
      room_ = room;
      room_of_neighbours_ = std::min(room_of_neighbours_, of_neighbours);
      return true;
    }
    room_ = std::min(room_, inside);
    return inside > 0.0;
  }
  /// Returns how far block b moves in a step at its present velocity, [L].
  double way_of_step(int b) const {
    const double arms = std::abs(blocks_.spin[b]) + blocks_.strain_rate.col(b).norm();
    return dt_ * (blocks_.velocity.col(b).norm() + 2.0 * longest_[b] * arms);
  }
  void add_contacts(std::vector<CornerOnEdge>& contacts) {
    const auto corner = [&](int part, int k) {
      return parts_.corner(part, k < parts_.corners(part) ? k : 0);
    };
    const auto add = [&](int k, int at, int edge) {
      const double beyond = answers_.beyond[k][lane_];
      if (beyond > 0.25 * room_)
        room_ = std::min(room_, beyond);
      else if (std::find(contacts.begin(), contacts.end(), CornerOnEdge{at, edge}) ==
               contacts.end())
        contacts.push_back({at, edge});
    };
    const int e = corner(own_, side_);
    if (facing_ < 0)
      return add(0, corner(other_, corner_), e);
    const int f = corner(other_, facing_);
    add(0, f, e);
    add(1, corner(other_, facing_ + 1), e);
    add(2, e, f);
    add(3, corner(own_, side_ + 1), f);
  }

  const Blocks& blocks_;
  const PairIndex& index_;
  const BlockParts& parts_;
  const std::vector<double>& longest_;
  double rounding_;  ///< [L] MotionBounds::rounding
  const FacingAnswers& answers_;
  int lane_;
  JointScratch& scratch_;
  int own_, other_;  ///< numbers of the part with the axis side and of the other part
  int side_, facing_, corner_;
  const NearPair& pair_;
  double dt_;
  double room_ = 0.0;
  double room_of_neighbours_ = std::numeric_limits<double>::infinity();
};

}  // namespace

void CertainDecisions::find(const Blocks& blocks, const BlockParts& parts,
                            const PairIndex& index, const Decisions& decisions,
                            const std::vector<int>& due, double dt) {
  decisions_.resize(std::max(decisions_.size(), due.size()));
  two_parts_.clear();
  for (std::size_t k = 0; k < due.size(); ++k) {
    decisions_[k].contacts.clear();
    decisions_[k].room = decisions_[k].room_of_neighbours =
        std::numeric_limits<double>::infinity();
    const NearPair& pair = index.pairs[due[k]];
    each_pair_of_parts(parts, pair.low, pair.high, [&](int p, int q) {
      if (std::max(parts.corners(p), parts.corners(q)) <= PartPairs::max_corners)
        two_parts_.push_back({static_cast<int>(k), {p, q}});
      else
        decisions_[k].room = 0.0;
    });
  }
  for (std::size_t first = 0; first < two_parts_.size(); first += lane_count)
    decide_lanes(blocks, parts, index, decisions, due, first, dt);
}

void CertainDecisions::decide_lanes(const Blocks& blocks, const BlockParts& parts,
                                    const PairIndex& index, const Decisions& decisions,
                                    const std::vector<int>& due, std::size_t first,
                                    double dt) {
  const int count =
      static_cast<int>(std::min<std::size_t>(lane_count, two_parts_.size() - first));
  lanes_.most = 0;
  lanes_.rigid = decisions.bounds.rigid;
  for (int i = 0; i < lane_count; ++i) {
    const TwoParts& two = two_parts_[first + (i < count ? i : 0)];
    for (int k = 0; k < 2; ++k) {
      const int part = two.part[k], block = parts.block(part);
      lanes_.block[k][i] = block;
      lanes_.corners[k][i] = parts.corners(part);
      lanes_.longest[k][i] = decisions.bounds.longest[block];
      lanes_.most = std::max(lanes_.most, parts.corners(part));
    }
  }
  for (int i = 0; i < lane_count; ++i)
    for (int k = 0; k < 2; ++k) {
      const int part = two_parts_[first + (i < count ? i : 0)].part[k];
      const int corners = parts.corners(part);
      for (int c = 0; c < lanes_.most; ++c)
        lanes_.corner[k][c][i] = parts.corner(part, c < corners ? c : 0);
    }
  kernels().find_faces(lanes_, state_of(blocks), answers_);
  for (int i = 0; i < count; ++i) {
    const TwoParts& two = two_parts_[first + i];
    CertainDecision& decision = decisions_[two.of];
    if (decision.room > 0.0)
      LaneDecision(blocks, parts, index, decisions, due[two.of], answers_, i, two.part,
                   scratch_, dt)
          .take(decision);
  }
}

}  // namespace blocks::dynamics
