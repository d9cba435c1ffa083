#include "dynamics/contact_handover.hpp"

#include <algorithm>
#include <cmath>

namespace blocks::dynamics {
namespace {

bool same_pair(const ContactGroup& g, const ContactGroup& h) {
  return (g.corner_block == h.corner_block && g.edge_block == h.edge_block) ||
         (g.corner_block == h.edge_block && g.edge_block == h.corner_block);
}

/// Looks for the record that can take most of one lost force.
class Heir {
 public:
  Heir(const Blocks& blocks, const Contacts& contacts, const ContactGroups& groups,
       const LostForce& lost, double stiffness)
      : contacts_(contacts), groups_(groups), lost_(lost), stiffness_(stiffness),
        from_(groups.all[lost.group]), corner_(contacts.corner[lost.record]) {
    const int edge = contacts.edge[lost.record];
    along_ = Vec2(blocks.corner.col(blocks.next[edge]) - blocks.corner.col(edge))
                 .normalized();
  }

  /// Edges of other blocks, or other edges of the same, that act on the corner.
  void look_at_corner() {
    for (int k = groups_.first_of_corner[corner_];
         k < groups_.first_of_corner[corner_ + 1]; ++k)
      consider(groups_.by_corner[k]);
  }
  /// Other corners of the two blocks, if the force keeps its direction. Groups of a
  /// pair stand side by side.
  void look_at_pair() {
    const int count = static_cast<int>(groups_.all.size());
    for (const int way : {-1, 1})
      for (int g = lost_.group + way;
           g >= 0 && g < count && same_pair(groups_.all[g], from_); g += way)
        if (groups_.acting(g) && cosine(g) > 0.95)
          consider(g);
  }

  /// The record, or -1.
  int record() const { return heir_ < 0 ? -1 : groups_.acting(heir_)->record; }
  double normal() const { return normal_; }
  double shear() const { return cosine(heir_) * lost_.shear; }

 private:
  /// Of the angle between the old edge and the group's; the edges of two blocks run in
  /// opposite senses.
  double cosine(int g) const {
    const LiveContact& live = *groups_.acting(g);
    const double c = along_.x() * live.tangent_x + along_.y() * live.tangent_y;
    return groups_.all[g].corner_block == from_.corner_block ? c : -c;
  }
  void consider(int g) {
    const LiveContact* live = groups_.acting(g);
    if (live == nullptr)
      return;
    const double own = contacts_.normal_elastic[live->record];
    const double both = std::min(std::sqrt(lost_.normal * lost_.normal + own * own),
                                 stiffness_ * live->overlap);
    if (both - own > gain_)
      heir_ = g, normal_ = both, gain_ = both - own;
  }

  const Contacts& contacts_;
  const ContactGroups& groups_;
  const LostForce& lost_;
  double stiffness_;
  const ContactGroup& from_;
  int corner_;
  Vec2 along_;
  int heir_ = -1;
  double normal_ = 0.0, gain_ = 0.0;
};

}  // namespace

void hand_over(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
               double normal_stiffness) {
  // in the order of the list, whenever each was found to be lost
  std::sort(groups.lost.begin(), groups.lost.end(),
            [](const auto& l, const auto& r) { return l.record < r.record; });
  for (const LostForce& lost : groups.lost) {
    Heir heir(blocks, contacts, groups, lost, normal_stiffness);
    heir.look_at_corner();
    heir.look_at_pair();
    const int i = heir.record();
    if (i < 0)
      continue;
    contacts.active[i] = 0;  // starts anew, with what it was handed
    contacts.normal_elastic[i] = heir.normal();
    if (contacts.shear_elastic[i] == 0.0)
      contacts.shear_elastic[i] = heir.shear();
  }
  groups.lost.clear();
}

}  // namespace blocks::dynamics
