#include "dynamics/contact_handover.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Looks for the record that can take most of one lost force.
class Heir {
 public:
  Heir(const Blocks& blocks, const Contacts& contacts, const ContactGroups& groups,
       const LostForce& lost, double stiffness)
      : blocks_(blocks), contacts_(contacts), groups_(groups), lanes_(groups.lanes),
        lost_(lost), stiffness_(stiffness), corner_(contacts.corner[lost.record]) {
    const int edge = contacts.edge[lost.record];
    along_ = unit_along(edge, blocks.next[edge]);
  }

  /// Edges of other blocks, or other edges of the same, that act on the corner.
  void look_at_corner() {
    for (int k = groups_.first_of_corner[corner_];
         k < groups_.first_of_corner[corner_ + 1]; ++k) {
      const int pair = groups_.pairs_of_corners[k];
      for (int g = groups_.pairs[pair].first; g < groups_.end_of(pair); ++g)
        if (contacts_.corner[groups_.all[g].first] == corner_)
          consider(g);
    }
  }
  /// Other corners of the two blocks, if the force keeps its direction. Groups of a
  /// pair stand side by side.
  void look_at_pair() {
    const int count = static_cast<int>(groups_.all.size());
    for (const int way : {-1, 1})
      for (int g = lost_.group + way;
           g >= 0 && g < count && same_pair(groups_.all[g].first); g += way)
        if (const int seat = groups_.acting(g); seat >= 0 && cosine(seat) > 0.95)
          consider(g);
  }

  /// Its seat, or -1.
  int seat() const { return heir_; }
  double normal() const { return normal_; }
  double shear() const { return cosine(heir_) * lost_.shear; }

 private:
  /// Of the angle between the old edge and the seat's; the edges of two blocks run in
  /// opposite senses.
  double cosine(int seat) const {
    const double c = along_.dot(unit_along(lanes_.at(seat, &SlotPlaces::edge),
                                           lanes_.at(seat, &SlotPlaces::edge_end)));
    return blocks_.corner_block[lanes_.at(seat, &SlotPlaces::corner)] ==
                   blocks_.corner_block[corner_]
               ? c
               : -c;
  }
  bool same_pair(int record) const {
    return pair_of(blocks_, contacts_, record) ==
           pair_of(blocks_, contacts_, lost_.record);
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 unit_along(int p1, int p2) const { return (at(p2) - at(p1)).normalized(); }
  double overlap(int seat) const {
    const int p1 = lanes_.at(seat, &SlotPlaces::edge),
              p2 = lanes_.at(seat, &SlotPlaces::edge_end);
    return std::max(0.0,
                    geometry::cross(at(lanes_.at(seat, &SlotPlaces::corner)) - at(p1),
                                    unit_along(p1, p2)));
  }
  void consider(int g) {
    const int seat = groups_.acting(g);
    if (seat < 0)
      return;
    const double own = lanes_.at(seat, &SlotSprings::normal_elastic);
    const double handed = std::max(0.0, cosine(seat)) * lost_.normal;
    const double both =
        std::min(std::sqrt(handed * handed + own * own), stiffness_ * overlap(seat));
    if (both - own > gain_)
      heir_ = seat, normal_ = both, gain_ = both - own;
  }

  const Blocks& blocks_;
  const Contacts& contacts_;
  const ContactGroups& groups_;
  const ContactLanes& lanes_;
  const LostForce& lost_;
  double stiffness_;
  int corner_;
  Vec2 along_;
  int heir_ = -1;
  double normal_ = 0.0, gain_ = 0.0;
};

}  // namespace

void hand_over(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
               double normal_stiffness) {
  // in the order of the list, whenever each was found to be lost
  std::sort(groups.lost.begin(), groups.lost.end(),
            [](const auto& l, const auto& r) { return l.record < r.record; });
  ContactLanes& lanes = groups.lanes;
  groups.heirs.clear();
  for (const LostForce& lost : groups.lost) {
    Heir heir(blocks, contacts, groups, lost, normal_stiffness);
    heir.look_at_corner();
    heir.look_at_pair();
    const int seat = heir.seat();
    if (seat < 0)
      continue;
    lanes.set(seat, &SlotPlaces::starts, true);  // anew, with what it was handed
    lanes.at(seat, &SlotSprings::normal_elastic) = heir.normal();
    if (lanes.at(seat, &SlotSprings::shear_elastic) == 0.0)
      lanes.at(seat, &SlotSprings::shear_elastic) = heir.shear();
    groups.heirs.push_back(lanes.set_of(seat / lane_count));
  }
  std::sort(groups.heirs.begin(), groups.heirs.end());
  groups.heirs.erase(std::unique(groups.heirs.begin(), groups.heirs.end()),
                     groups.heirs.end());
  groups.lost.clear();
}

}  // namespace blocks::dynamics
