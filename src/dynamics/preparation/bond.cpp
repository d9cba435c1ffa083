#include "dynamics/preparation/bond.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dynamics/contacts/law_table.hpp"
#include "dynamics/preparation/contact_table.hpp"
#include "dynamics/preparation/faces.hpp"
#include "dynamics/search/near_pairs.hpp"

namespace blocks::dynamics {
namespace {

/// Bonds a contact. Adds it if it is not listed.
void bond(Model& model, ContactTable& table, const CornerOnEdge& at, int id) {
  LawState& state = table.find_or_add(at).second;
  if (!state.bonded || state.failed)
    ++model.bonds_made;
  state.law = id, state.bonded = true, state.failed = false;
}

}  // namespace

int bond_faces(Model& model, int id, double tolerance) {
  const Blocks& blocks = model.blocks;
  LawTable laws;
  laws.make(model.settings, blocks);
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(blocks, tolerance, memory, pairs);
  ContactTable table(model);
  std::vector<CornerOnEdge> ends;
  int bonded = 0;
  for (const NearPair& pair : pairs) {
    if (!laws.may_act(blocks, pair.low, pair.high))
      continue;
    ends.clear();
    each_face(blocks, pair.low, pair.high, [&](const Face& face) {
      const double slack = face.slack(tolerance);
      if (!face.is_flush(tolerance, slack))
        return;
      for (const bool at_end_of_e : {false, true}) {
        const FaceEnd end = face.end(at_end_of_e, slack);
        ends.insert(ends.end(), end.records.begin(), end.records.begin() + end.count);
      }
    });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const CornerOnEdge& at = ends[i];
      const int law = laws.law_of(blocks, at.corner, at.edge);
      const bool is_new =
          std::find(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(i), at) ==
          ends.begin() + static_cast<std::ptrdiff_t>(i);
      if (is_new && law != 0 && laws.bit(law) != barton_bit &&
          (id == 0 || laws.id(law) == id))
        bond(model, table, at, laws.id(law)), ++bonded;
    }
  }
  table.finish();
  return bonded;
}

}  // namespace blocks::dynamics
