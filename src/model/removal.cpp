#include "model/removal.hpp"

#include <algorithm>

#include "model/drives.hpp"

namespace blocks {
namespace {

void remove_contacts(Model& model) {
  const Blocks& blocks = model.blocks;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto [low, high] = pair_of(blocks, model.contacts[i]);
    if (blocks.is_removed(low) || blocks.is_removed(high)) {
      if (!model.law_states.empty() && model.law_states[i].bonded &&
          !model.law_states[i].failed)
        --model.bonds_made;
      continue;
    }
    model.contacts[kept] = model.contacts[i];
    if (!model.law_states.empty())
      model.law_states[kept] = model.law_states[i];
    ++kept;
  }
  model.contacts.resize(kept);
  if (!model.law_states.empty())
    model.law_states.resize(kept);
}

void remove_plane_contacts(Model& model) {
  std::erase_if(model.plane_contacts, [&](const PlaneContact& contact) {
    return model.blocks.is_removed(model.blocks.corner_block[contact.corner]);
  });
}

void remove_loads(Model& model) {
  const auto is_removed = [&](const auto& load) {
    return model.blocks.is_removed(load.block);
  };
  std::erase_if(model.loads.pressures, is_removed);
  std::erase_if(model.loads.forces, is_removed);
  std::erase_if(model.loads.quiet_sides, is_removed);
}

}  // namespace

void remove_blocks(Model& model, const std::vector<int>& chosen) {
  Blocks& blocks = model.blocks;
  for (const int b : chosen) {
    blocks.fix(b, Fixity::removed);
    end_drive(model, b);
    blocks.force.col(b).setZero();
    blocks.moment[b] = 0.0;
    blocks.applied.col(b).setZero();
    blocks.stress.col(b).setZero();
    if (b == model.time_step.block)
      model.time_step.blocks = 0;
  }
  remove_contacts(model);
  remove_plane_contacts(model);
  remove_loads(model);
  model.search.invalidate();
}

void free_blocks(Model& model, const std::vector<int>& chosen) {
  for (const int b : chosen)
    model.blocks.fixity[b] = Fixity::free, end_drive(model, b);
  if (!model.settings.rigid)
    model.time_step.blocks = 0;
  model.search.invalidate();
}

}  // namespace blocks
