#include "dynamics/contact_readings.hpp"

#include <algorithm>

#include "dynamics/contact_lanes.hpp"

namespace blocks::dynamics {
namespace {

/// Lets the pairs first .. last - 1 of one window act once more, with readings.
void act_again(const Blocks& blocks, ContactGroups& groups, const ContactLaw& law,
               bool rigid, int first, int last) {
  int begin = groups.lanes.sets(), end = 0;
  for (int p = first; p < last; ++p)
    if (const int lane = groups.pairs[p].lane; lane >= 0) {
      begin = std::min(begin, lane / lane_count);
      end = std::max(end, lane / lane_count + 1);
    }
  if (begin >= end)
    return;
  groups.lanes.read_from(begin, rigid);
  lane_arithmetic().act(groups.lanes, rows_of(blocks), law, rigid, true, begin, end);
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
  groups.begin_store(contacts);
  const int pairs = static_cast<int>(groups.pairs.size());
  for (int first = 0; first < pairs; first += pairs_of_window) {
    const int last = std::min(pairs, first + pairs_of_window);
    act_again(blocks, groups, law, settings.rigid, first, last);
    for (int p = first; p < last; ++p) {
      const ContactPair& pair = groups.pairs[p];
      if (pair.lane < 0)
        continue;
      for (int g = pair.first; g < pair.last; ++g)
        if (groups.acting(g) >= 0)
          groups.store(contacts, g, true);
      if (settings.rigid)
        add_stress(blocks, groups.lanes, pair);
    }
  }
  groups.read = true;
}

}  // namespace blocks::dynamics
