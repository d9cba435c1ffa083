#include "dynamics/spring_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Looks for the contact that can take most of one lost spring.
class Heir {
 public:
  Heir(const Blocks& blocks, const PairContacts& all, const LostSpring& lost,
       double stiffness)
      : blocks_(blocks), all_(all), lanes_(all.lanes), lost_(lost),
        stiffness_(stiffness),
        along_(unit_along(lost.at.edge, blocks.next[lost.at.edge])) {}

  void look() {
    const int block = blocks_.corner_block[lost_.at.corner];
    for (int k = all_.first_of_block[block]; k < all_.first_of_block[block + 1]; ++k)
      all_.each_seat(all_.pairs_of_blocks[k], [&](int seat) {
        if (touches(seat) && all_.at(seat).corner == lost_.at.corner)
          consider(seat);
      });
    all_.each_seat(lost_.pair, [&](int seat) {
      if (touches(seat) && cosine(seat) > 0.95)
        consider(seat);
    });
  }

  /// Its seat, or -1.
  int seat() const { return heir_; }
  double normal() const { return normal_; }
  double shear() const { return cosine(heir_) * lost_.shear; }

 private:
  bool touches(int seat) const { return lanes_.is(seat, &SlotPlaces::touches); }
  /// Of the angle between the old edge and the seat's; the edges of two blocks run in
  /// opposite senses.
  double cosine(int seat) const {
    const double c =
        along_.dot(unit_along(all_.at(seat).edge, blocks_.next[all_.at(seat).edge]));
    return blocks_.corner_block[all_.at(seat).corner] ==
                   blocks_.corner_block[lost_.at.corner]
               ? c
               : -c;
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 unit_along(int p1, int p2) const { return (at(p2) - at(p1)).normalized(); }
  double overlap(int seat) const {
    const auto [corner, edge] = all_.at(seat);
    return std::max(0.0, geometry::cross(at(corner) - at(edge),
                                         unit_along(edge, blocks_.next[edge])));
  }
  void consider(int seat) {
    const double own = lanes_.at(seat, &SlotSprings::normal_elastic);
    const double handed = std::max(0.0, cosine(seat)) * lost_.normal;
    const double both =
        std::min(std::sqrt(handed * handed + own * own), stiffness_ * overlap(seat));
    if (both - own > gain_)
      heir_ = seat, normal_ = both, gain_ = both - own;
  }

  const Blocks& blocks_;
  const PairContacts& all_;
  const ContactLanes& lanes_;
  const LostSpring& lost_;
  double stiffness_;
  Vec2 along_;
  int heir_ = -1;
  double normal_ = 0.0, gain_ = 0.0;
};

}  // namespace

void transfer_springs(const Blocks& blocks, PairContacts& all,
                      double normal_stiffness) {
  // in the order of the list, whichever thread found them
  std::sort(all.lost.begin(), all.lost.end(),
            [](const LostSpring& l, const LostSpring& r) {
              return std::tie(l.pair, l.at.corner, l.at.edge) <
                     std::tie(r.pair, r.at.corner, r.at.edge);
            });
  ContactLanes& lanes = all.lanes;
  all.heirs.clear();
  for (const LostSpring& lost : all.lost) {
    Heir heir(blocks, all, lost, normal_stiffness);
    heir.look();
    const int seat = heir.seat();
    if (seat < 0)
      continue;
    lanes.set(seat, &SlotPlaces::starts, true);  // anew, with what it was handed
    lanes.at(seat, &SlotSprings::normal_elastic) = heir.normal();
    if (lanes.at(seat, &SlotSprings::shear_elastic) == 0.0)
      lanes.at(seat, &SlotSprings::shear_elastic) = heir.shear();
    all.heirs.push_back(lanes.set_of(seat / lane_count));
  }
  all.lost.clear();
  std::sort(all.heirs.begin(), all.heirs.end());
  all.heirs.erase(std::unique(all.heirs.begin(), all.heirs.end()), all.heirs.end());
}

}  // namespace blocks::dynamics
