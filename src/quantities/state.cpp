#include "quantities/state.hpp"

namespace blocks::quantities {

int Corners::count(int b) const {
  const auto k = static_cast<std::size_t>(b);
  if (blocks_ != nullptr)
    return b < blocks_->size() ? blocks_->corners_of(b) : 0;
  return k < outlines_->size() ? static_cast<int>((*outlines_)[k].size()) : 0;
}

Eigen::Vector2d Corners::at(int b, int c) const {
  const auto k = static_cast<std::size_t>(b);
  if (blocks_ != nullptr)
    return blocks_->corner.col(blocks_->first_corner[k] + c);
  return (*outlines_)[k][static_cast<std::size_t>(c)];
}

bool BlockStates::is_removed(int b) const {
  const auto k = static_cast<std::size_t>(b);
  return fixity != nullptr ? (*fixity)[k] == Fixity::removed
                           : (*fixed)[k] == static_cast<int>(Fixity::removed);
}

bool BlockStates::is_free(int b) const {
  const auto k = static_cast<std::size_t>(b);
  return fixity != nullptr ? (*fixity)[k] == Fixity::free
                           : (*fixed)[k] == static_cast<int>(Fixity::free);
}

int BlockStates::present() const {
  int count = 0;
  for (int b = 0; b < size(); ++b)
    count += is_removed(b) ? 0 : 1;
  return count;
}

BlockStates states_of(const Blocks& b) {
  return {{b.centroid, Corners(b)},
          b.velocity,
          b.force,
          b.angle,
          b.spin,
          b.moment,
          b.area,
          b.mass,
          b.inertia,
          b.stress,
          b.applied,
          b.strain_rate,
          b.material,
          &b.fixity};
}

void list_contacts(const Model& model, std::vector<ContactState>& contacts) {
  const std::vector<int>& block_of = model.blocks.corner_block;
  const auto number = [&](int corner) {
    return block_of[static_cast<std::size_t>(corner)] + 1;
  };
  contacts.clear();
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const Contact& contact = model.contacts[i];
    contacts.push_back({number(contact.corner), number(contact.edge),
                        contact.normal_force, contact.shear_force, contact.overlap});
    if (i < model.law_states.size() && model.law_states[i].law != 0)
      contacts.back().state = model.law_states[i];
  }
  for (const PlaneContact& contact : model.plane_contacts)
    if (contact.active)
      contacts.push_back(
          {number(contact.corner), 0, contact.normal_force, 0.0, contact.overlap});
}

}  // namespace blocks::quantities
