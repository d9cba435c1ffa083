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
      consider(groups_.all[groups_.by_corner[k]]);
  }
  /// Other corners of the two blocks, if the force keeps its direction. Groups of a
  /// pair stand side by side.
  void look_at_pair() {
    const int count = static_cast<int>(groups_.all.size());
    for (const int way : {-1, 1})
      for (int g = lost_.group + way;
           g >= 0 && g < count && same_pair(groups_.all[g], from_); g += way)
        if (groups_.all[g].acting >= 0 && cosine(groups_.all[g]) > 0.95)
          consider(groups_.all[g]);
  }

  const ContactGroup* group() const { return heir_; }
  double normal() const { return normal_; }
  double shear() const { return cosine(*heir_) * lost_.shear; }

 private:
  /// Of the angle between the old edge and the group's; the edges of two blocks run in
  /// opposite senses.
  double cosine(const ContactGroup& group) const {
    const double c = along_.x() * group.tangent_x + along_.y() * group.tangent_y;
    return group.corner_block == from_.corner_block ? c : -c;
  }
  void consider(const ContactGroup& group) {
    if (group.acting < 0)
      return;
    const double own = contacts_.normal_elastic[group.acting];
    const double both = std::min(std::sqrt(lost_.normal * lost_.normal + own * own),
                                 stiffness_ * group.overlap);
    if (both - own > gain_)
      heir_ = &group, normal_ = both, gain_ = both - own;
  }

  const Contacts& contacts_;
  const ContactGroups& groups_;
  const LostForce& lost_;
  double stiffness_;
  const ContactGroup& from_;
  int corner_;
  Vec2 along_;
  const ContactGroup* heir_ = nullptr;
  double normal_ = 0.0, gain_ = 0.0;
};

}  // namespace

void hand_over(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
               double normal_stiffness) {
  for (const LostForce& lost : groups.lost) {
    Heir heir(blocks, contacts, groups, lost, normal_stiffness);
    heir.look_at_corner();
    heir.look_at_pair();
    if (heir.group() == nullptr)
      continue;
    const int i = heir.group()->acting;
    contacts.active[i] = 0;  // starts anew, with what it was handed
    contacts.normal_elastic[i] = heir.normal();
    if (contacts.shear_elastic[i] == 0.0)
      contacts.shear_elastic[i] = heir.shear();
  }
  groups.lost.clear();
}

}  // namespace blocks::dynamics
