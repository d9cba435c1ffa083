#include "dynamics/pair_step.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "dynamics/huge_pages.hpp"
#include "dynamics/symmetry_planes.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::dynamics {
namespace {

/// Adds others, which are ordered, to the pairs found. Each pair is there once.
void add_pairs(std::vector<NearPair>& found, const std::vector<NearPair>& others) {
  if (std::includes(found.begin(), found.end(), others.begin(), others.end()))
    return;
  std::vector<NearPair> both;
  std::set_union(found.begin(), found.end(), others.begin(), others.end(),
                 std::back_inserter(both));
  found.swap(both);
}

}  // namespace

void update_pairs(Model& model, SearchBuffers& buffers,
                  const std::vector<NearPair>& also) {
  PairContacts& all = buffers.pairs;
  const Blocks& blocks = model.blocks;
  const bool known = all.loaded && buffers.grouped_update == model.search.updates;
  if (known && model.search.current)
    return;
  const Profile::Timer timer(buffers.profile, Profile::search);
  if (!model.search.current) {
    model.search.left = list_tolerance(model);
    model.search.current = true;
    ++model.search.updates;
    update_plane_contacts(model, buffers.next_planes, model.search.left);
  }
  std::vector<NearPair>& found = buffers.near_pairs;
  find_near_pairs(blocks, model.search.left, buffers.near, found);
  std::vector<NearPair> of_springs;
  if (known) {
    all.take_out(all.held);
    for (std::size_t k = 0; k < all.held.pair.size(); ++k)
      for (int i = all.held.first[k]; i < all.held.first[k + 1]; ++i)
        if (all.held.all[i].normal > 0.0)
          of_springs.push_back(
              {all.pairs[all.held.pair[k]].low, all.pairs[all.held.pair[k]].high, -1});
  } else {
    for (const ActingContact& contact : model.contacts.acting) {
      const auto [low, high] = pair_of(blocks, model.contacts, contact.record);
      if (blocks.is_free(low) || blocks.is_free(high))
        of_springs.push_back({low, high, -1});
    }
  }
  // Pairs whose contacts have springs stay, near or not: the springs need successors.
  of_springs.erase(std::unique(of_springs.begin(), of_springs.end()), of_springs.end());
  add_pairs(found, of_springs);
  add_pairs(found, also);
  const bool moved_only = known && buffers.outdated_at == model.steps;
  all.take(found, blocks, model.settings.rigid, buffers.workers->threads(), known,
           moved_only);
  if (!known)
    all.take_from(blocks, model.contacts, all.held);
  all.unseated.clear();
  all.make_lanes(blocks, model.settings, all.held, all.unseated);
  buffers.grouped_update = model.search.updates;
  buffers.outdated_at = -1;
  if (std::exchange(buffers.corners_at, blocks.corner.data()) != blocks.corner.data())
    move_to_huge_pages(blocks);
}

void catch_up_pairs(Model& model, SearchBuffers& buffers) {
  PairContacts& all = buffers.pairs;
  if (!std::exchange(all.list_is_behind, false))
    return;
  Blocks& blocks = model.blocks;
  if (model.settings.rigid && all.read)
    blocks.applied.array().rowwise() /= blocks.area.transpose().array();
  else if (model.settings.rigid)
    blocks.applied.setZero();
  if (!all.read)
    all.store(model.contacts);
}

}  // namespace blocks::dynamics
