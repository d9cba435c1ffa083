#include "dynamics/contact_readings.hpp"

#include <algorithm>

#include "dynamics/contact_lanes.hpp"

namespace blocks::dynamics {
namespace {

/// Lets the sets of one window act once more, with readings.
void act_again(const Blocks& blocks, ContactGroups& groups, const ContactLaw& law,
               bool rigid, SetRange sets) {
  if (sets.first >= sets.last)
    return;
  groups.lanes.read_from(sets.first, rigid);
  lane_arithmetic().act(groups.lanes, rows_of(blocks), law, rigid, true, sets.first,
                        sets.last);
}

/// f_i x_j of a pair, to both blocks.
void add_stress(Blocks& blocks, const ContactLanes& lanes, const ContactPair& pair) {
  const PairStress& of = lanes.stresses[pair.lane - lanes.first_stress * lane_count];
  for (int i = 0; i < 4; ++i) {
    blocks.applied(i, pair.low) += of.low[i];
    blocks.applied(i, pair.high) += of.high[i];
  }
}

}  // namespace

void read_contacts(Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                   const Settings& settings, double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  if (settings.rigid)
    blocks.applied.setZero();
  StoredLanes stored(groups.lanes);
  groups.each_window([&](int first, int last) {
    const SetRange sets = groups.sets_of(first);
    act_again(blocks, groups, law, settings.rigid, sets);
    for (int p = first; p < last; ++p) {
      const ContactPair& pair = groups.pairs[p];
      if (pair.lane < 0)
        continue;
      for (int g = pair.first; g < groups.end_of(p); ++g)
        if (groups.acting(g) >= 0)
          groups.store(contacts, g, true);
      if (settings.rigid)
        add_stress(blocks, groups.lanes, pair);
    }
    stored.passed(sets.last);
  });
  groups.loaded = false;
  groups.read = true;
}

}  // namespace blocks::dynamics
