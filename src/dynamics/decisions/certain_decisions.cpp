#include "dynamics/decisions/certain_decisions.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {
namespace {

using geometry::Certainty;

/// Adds the kernel's answer about two parts to the decision of their blocks.
class LaneDecision {
 public:
  LaneDecision(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
               const Decisions& decisions, int p, const FacingAnswers& answers,
               int lane, const int* part)
      : blocks_(blocks), index_(index), parts_(parts), bounds_(decisions.bounds),
        answers_(answers), lane_(lane), own_(part[answers.own[lane] > 0.0]),
        other_(part[answers.own[lane] <= 0.0]),
        side_(static_cast<int>(answers.side[lane])),
        facing_(static_cast<int>(answers.facing[lane])),
        corner_(static_cast<int>(answers.corner[lane])), pair_(index.pairs[p]) {}

  void take(CertainDecision& decision) {
    const double apart = answers_.apart[lane_];
    validity_ = answers_.faces[lane_];
    // Parts that are near get their contacts before they touch.
    if (apart > 0.0 && apart > Certainty::apart_share * validity_) {
      decision.validity = std::min(decision.validity, apart);
      return;
    }
    if (!(validity_ > 0.0) || !sides_are_plain() || !third_parts_are_away()) {
      decision.validity = 0.0;
      return;
    }
    add_contacts(decision.contacts);
    decision.validity = std::min(decision.validity, validity_);
    decision.growth = std::min(decision.growth, growth_);
  }

 private:
  /// Returns whether the two sides are edges and no others are in line with them.
  bool sides_are_plain() const {
    return parts_.is_isolated(own_, side_) &&
           (facing_ < 0 || parts_.is_isolated(other_, facing_));
  }
  /// Returns whether all third parts are so far from the contact point that they hide
  /// nothing, even after some motion.
  bool third_parts_are_away() {
    bool are_away = answers_.reach[lane_] <= bounds_.longest[parts_.block(own_)];
    const auto visit = [&](int part) { are_away = are_away && is_away(part); };
    each_third_part(blocks_, parts_, index_.neighbours, own_, other_, visit);
    each_third_part(blocks_, parts_, index_.neighbours, other_, own_, visit);
    return are_away;
  }
  bool is_away(int part) {
    const double min_clearance =
        Certainty::min_clearance *
        std::min(bounds_.longest[pair_.low], bounds_.longest[pair_.high]);
    const double beyond =
        answers_.reach[lane_] + answers_.rounding[lane_] + bounds_.rounding;
    const double clearance = distance_to(part, beyond + min_clearance) - beyond;
    growth_ = std::min(growth_, Certainty::growth_per_clearance * clearance);
    return clearance >= min_clearance;
  }
  /// Returns a lower bound of the distance from the contact point to a part, [L]. It is
  /// found with less work if it is at least `enough`.
  double distance_to(int part, double enough) const {
    const Vec2 point(answers_.x[lane_], answers_.y[lane_]);
    const int block = parts_.block(part);
    const double away =
        (point - blocks_.centroid.col(block)).lpNorm<Eigen::Infinity>() -
        bounds_.longest[block] * bounds_.stretch(blocks_, block);
    if (away >= enough)
      return away;
    double farthest = 0.0;
    Vec2 start = blocks_.corner.col(parts_.corner(part, parts_.corners(part) - 1));
    for (int k = 0; k < parts_.corners(part) && farthest < enough; ++k) {
      const Vec2 end = blocks_.corner.col(parts_.corner(part, k)), along = end - start;
      const double outside = geometry::cross(along, point - start) / along.norm();
      farthest = std::max(farthest, outside);
      start = end;
    }
    return farthest;
  }
  void add_contacts(std::vector<CornerOnEdge>& contacts) {
    const auto corner = [&](int part, int k) {
      return parts_.corner(part, k < parts_.corners(part) ? k : 0);
    };
    const auto add = [&](int k, int at, int edge) {
      const double beyond = answers_.beyond[k][lane_];
      if (beyond > Certainty::beyond_share * validity_)
        validity_ = std::min(validity_, beyond);
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
  const MotionBounds& bounds_;
  const FacingAnswers& answers_;
  int lane_;
  int own_, other_;  ///< numbers of the part with the axis side and of the other part
  int side_, facing_, corner_;
  const NearPair& pair_;
  double validity_ = 0.0;
  double growth_ = Certainty::growth_alone;
};

}  // namespace

void CertainDecisions::find(const Blocks& blocks, const BlockParts& parts,
                            const PairIndex& index, const Decisions& decisions,
                            const std::vector<int>& due) {
  decisions_.resize(std::max(decisions_.size(), due.size()));
  two_parts_.clear();
  for (std::size_t k = 0; k < due.size(); ++k) {
    decisions_[k].contacts.clear();
    decisions_[k].validity = decisions_[k].growth =
        std::numeric_limits<double>::infinity();
    const NearPair& pair = index.pairs[due[k]];
    each_pair_of_parts(parts, pair.low, pair.high, [&](int p, int q) {
      if (std::max(parts.corners(p), parts.corners(q)) <= PartPairs::max_corners)
        two_parts_.push_back({static_cast<int>(k), {p, q}});
      else
        decisions_[k].validity = 0.0;
    });
  }
  for (std::size_t first = 0; first < two_parts_.size(); first += lane_count)
    decide_lanes(blocks, parts, index, decisions, due, first);
}

void CertainDecisions::decide_lanes(const Blocks& blocks, const BlockParts& parts,
                                    const PairIndex& index, const Decisions& decisions,
                                    const std::vector<int>& due, std::size_t first) {
  const int count =
      static_cast<int>(std::min<std::size_t>(lane_count, two_parts_.size() - first));
  lanes_.used_corners = 0;
  lanes_.rigid = decisions.bounds.rigid;
  for (int i = 0; i < lane_count; ++i) {
    const TwoParts& lane_parts = two_parts_[first + (i < count ? i : 0)];
    for (int k = 0; k < 2; ++k) {
      const int part = lane_parts.part[k], block = parts.block(part);
      lanes_.block[k][i] = block;
      lanes_.corners[k][i] = parts.corners(part);
      lanes_.longest[k][i] = decisions.bounds.longest[block];
      lanes_.used_corners = std::max(lanes_.used_corners, parts.corners(part));
    }
  }
  for (int i = 0; i < lane_count; ++i)
    for (int k = 0; k < 2; ++k) {
      const int part = two_parts_[first + (i < count ? i : 0)].part[k];
      const int corners = parts.corners(part);
      for (int c = 0; c < lanes_.used_corners; ++c)
        lanes_.corner[k][c][i] = parts.corner(part, c < corners ? c : 0);
    }
  kernels().find_facing_sides(lanes_, state_of(blocks), answers_);
  for (int i = 0; i < count; ++i) {
    const TwoParts& lane_parts = two_parts_[first + i];
    CertainDecision& decision = decisions_[lane_parts.due];
    if (decision.validity > 0.0)
      LaneDecision(blocks, parts, index, decisions, due[lane_parts.due], answers_, i,
                   lane_parts.part)
          .take(decision);
  }
}

}  // namespace blocks::dynamics
