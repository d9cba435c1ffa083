#include "dynamics/pair_forces.hpp"

#include <algorithm>
#include <bit>

namespace blocks::dynamics {
namespace {

ContactLaw law_of(const Settings& settings, double dt) {
  return {settings.normal_stiffness, settings.shear_stiffness, settings.friction, dt};
}

/// Calls visit(seat) for each seat of a set whose bit is set.
template <class Visit>
void each_marked(const ContactLanes& lanes, int set, LaneBits SlotPlaces::*marks,
                 const Visit& visit) {
  const LanePairs& pairs = lanes.pairs[set];
  for (int slot = pairs.first_slot; slot < pairs.first_slot + pairs.slots; ++slot)
    for (unsigned bits = lanes.places[slot].*marks; bits != 0; bits &= bits - 1)
      visit(slot * lane_count + std::countr_zero(bits));
}

/// Decides exactly which contacts of a set touch where the lanes were in doubt.
void settle_doubts(const Blocks& blocks, ContactLanes& lanes, int set) {
  each_marked(lanes, set, &SlotPlaces::in_doubt, [&](int seat) {
    const auto at = [&](LaneRow<int> SlotPlaces::*which) {
      return Vec2(blocks.corner.col(lanes.at(seat, which)));
    };
    const Vec2 c = at(&SlotPlaces::corner), p1 = at(&SlotPlaces::edge),
               p2 = at(&SlotPlaces::edge_end);
    if (geometry::overlap_sign(c, p1, p2) > 0 && geometry::between(c, p1, p2))
      return;
    lanes.set(seat, &SlotPlaces::touches, false);
    if (!lanes.is(seat, &SlotPlaces::starts))
      lanes.set(seat, &SlotPlaces::ends, true), lanes.pairs[set].ends = true;
  });
}

/// The springs of contacts of a set that have ceased to act.
void collect_lost(const PairContacts& all, int set, std::vector<LostSpring>& lost) {
  const ContactLanes& lanes = all.lanes;
  each_marked(lanes, set, &SlotPlaces::ends, [&](int seat) {
    if (const double normal = lanes.at(seat, &SlotSprings::normal_elastic);
        normal > 0.0)
      lost.push_back({all.pair_of_lane[set * lane_count + seat % lane_count],
                      all.at(seat), normal,
                      lanes.at(seat, &SlotSprings::shear_elastic)});
  });
}

}  // namespace

Extremes evaluate_pairs(const Blocks& blocks, PairContacts& all,
                        const Settings& settings, double dt, Workers& workers,
                        bool transfers_springs) {
  const ContactLaw law = law_of(settings, dt);
  const LaneArithmetic& arithmetic = lane_arithmetic();
  const BlockRows rows = rows_of(blocks);
  const auto include = [&](int part, const LaneExtremes& most) {
    all.shares[part].extremes.include(most.overlap, most.spring);
  };
  const auto act = [&](int part, int set) {
    include(part,
            arithmetic.act(all.lanes, rows, law, settings.rigid, false, set, set + 1));
  };
  workers.each(all.split.sets, [&](int part, int first, int last) {
    include(part, arithmetic.touch_and_act(all.lanes, rows, law, settings.rigid, first,
                                           last));
    for (int set = first; set < last; ++set) {
      if (all.lanes.pairs[set].in_doubt) {
        settle_doubts(blocks, all.lanes, set);
        act(part, set);
      }
      if (all.lanes.pairs[set].ends)
        collect_lost(all, set, all.shares[part].lost);
    }
  });
  for (PairContacts::Share& share : all.shares) {
    all.lost.insert(all.lost.end(), share.lost.begin(), share.lost.end());
    share.lost.clear();
  }
  if (!transfers_springs)
    all.lost.clear();
  transfer_springs(blocks, all, settings.normal_stiffness);
  for (const int set : all.heirs)
    act(0, set);
  Extremes extremes;
  for (PairContacts::Share& share : all.shares) {
    extremes.include(share.extremes.overlap, share.extremes.spring);
    share.extremes = {};
  }
  return extremes;
}

void PairContacts::store(Contacts& contacts) const {
  contacts.corner.clear(), contacts.edge.clear();
  contacts.acting.clear();
  for (int p = 0; p < static_cast<int>(pairs.size()); ++p)
    each_seat(p, [&](int seat) {
      if (!lanes.is(seat, &SlotPlaces::touches))
        return;
      ActingContact& contact = contacts.acting.emplace_back();
      contact.record = static_cast<int>(contacts.corner.size());
      contact.normal_elastic = lanes.at(seat, &SlotSprings::normal_elastic);
      contact.shear_elastic = lanes.at(seat, &SlotSprings::shear_elastic);
      contacts.corner.push_back(at(seat).corner);
      contacts.edge.push_back(at(seat).edge);
    });
  contacts.active.assign(contacts.corner.size(), true);
}

void read_pairs(Blocks& blocks, Contacts& contacts, PairContacts& all,
                const Settings& settings, double dt) {
  ContactLanes& lanes = all.lanes;
  if (settings.rigid)
    blocks.applied.setZero();
  if (lanes.sets() > 0) {
    lanes.read_from(0, settings.rigid);
    lane_arithmetic().act(lanes, rows_of(blocks), law_of(settings, dt), settings.rigid,
                          true, 0, lanes.sets());
  }
  all.store(contacts);
  auto contact = contacts.acting.begin();
  for (int p = 0; p < static_cast<int>(all.pairs.size()); ++p) {
    all.each_seat(p, [&](int seat) {
      if (!lanes.is(seat, &SlotPlaces::touches))
        return;
      const int slot = seat / lane_count, k = seat % lane_count;
      const SlotReadings& reading = lanes.readings[slot - lanes.first_reading];
      contact->normal_elastic = lanes.advanced[slot].normal_elastic[k];
      contact->shear_elastic = lanes.advanced[slot].shear_elastic[k];
      contact->normal_force = reading.normal_force[k];
      contact->shear_force = reading.shear_force[k];
      contact->overlap = reading.overlap[k];
      ++contact;
    });
    if (settings.rigid && all.pairs[p].lane >= 0) {
      const PairStress& of =
          lanes.stresses[all.pairs[p].lane - lanes.first_stress * lane_count];
      for (int i = 0; i < 4; ++i) {
        blocks.applied(i, all.pairs[p].low) += of.low[i];
        blocks.applied(i, all.pairs[p].high) += of.high[i];
      }
    }
  }
}

}  // namespace blocks::dynamics
