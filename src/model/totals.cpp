#include <algorithm>

#include "model/model.hpp"

namespace blocks {

ModelTotals totals(const Model& model) {
  const Blocks& blocks = model.blocks;
  ModelTotals sum;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))  // driven blocks have no finite mass
      continue;
    const Vec2 v = blocks.velocity.col(b);
    const Vec2 momentum = blocks.mass[b] * v;
    sum.kinetic_energy +=
        0.5 * (momentum.dot(v) + blocks.inertia[b] * blocks.spin[b] * blocks.spin[b]);
    sum.momentum += momentum;
    sum.angular_momentum += geometry::cross(blocks.centroid.col(b), momentum) +
                            blocks.inertia[b] * blocks.spin[b];
    sum.fastest = std::max(sum.fastest, v.norm());
  }
  sum.listed_contacts =
      static_cast<int>(model.contacts.size() + model.plane_contacts.size());
  const auto count = [&](double overlap) {
    ++sum.active_contacts;
    sum.worst_overlap = std::max(sum.worst_overlap, overlap);
  };
  for (const Contact& contact : model.contacts)
    count(contact.overlap);
  long intact_bonds = 0;
  for (const LawState& state : model.law_states) {
    sum.with_law += state.law != 0;
    sum.bonded += state.law != 0 && state.bonded;
    sum.failed += state.law != 0 && state.failed;
    intact_bonds += state.bonded && !state.failed;
  }
  sum.broken = model.bonds_made - intact_bonds;
  for (const PlaneContact& contact : model.plane_contacts)
    if (contact.active)
      count(contact.overlap);
  return sum;
}

}  // namespace blocks
