#include "dynamics/update_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "dynamics/contacts/contact_list.hpp"
#include "dynamics/kept_state.hpp"
#include "dynamics/loads/symmetry_planes.hpp"
#include "dynamics/search/list_tolerance.hpp"
#include "dynamics/support/memory_pages.hpp"

namespace blocks::dynamics {
namespace {

/// Adds other pairs to those found, without duplicates. Both lists are sorted.
void add_pairs(std::vector<NearPair>& found, const std::vector<NearPair>& others) {
  if (std::includes(found.begin(), found.end(), others.begin(), others.end()))
    return;
  std::vector<NearPair> both;
  std::set_union(found.begin(), found.end(), others.begin(), others.end(),
                 std::back_inserter(both));
  found.swap(both);
}

/// Returns the pairs whose contacts have springs, sorted.
std::vector<NearPair> pairs_with_springs(const PairIndex& index,
                                         const ContactsOfPairs& contacts) {
  std::vector<NearPair> found;
  for (std::size_t k = 0; k < contacts.pair.size(); ++k)
    for (int i = contacts.first[k]; i < contacts.first[k + 1]; ++i)
      if (const PairContact contact = contacts.at(static_cast<std::size_t>(i));
          contact.normal > 0.0 || contact.may_be_held()) {
        found.push_back(index.pairs[contacts.pair[k]]);
        break;
      }
  return found;
}
std::vector<NearPair> pairs_with_springs(const Blocks& blocks,
                                         const std::vector<Contact>& list) {
  std::vector<NearPair> found;
  for (const Contact& contact : list) {
    const auto [low, high] = pair_of(blocks, contact);
    if (blocks.may_touch(low, high))
      found.push_back({low, high});
  }
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Renumbers the pairs of contacts, and moves the slot counts of pairs, from the old
/// list to the new one. Contacts of a pair that the new list lacks get pair number -1.
void renumber(const std::vector<NearPair>& old, const std::vector<NearPair>& now,
              ContactsOfPairs& contacts, std::vector<int>& slots) {
  std::vector<int> new_slots(now.size(), 0);
  std::size_t next = 0, k = 0;
  for (std::size_t i = 0; i < old.size(); ++i) {
    while (k < now.size() && now[k] < old[i])
      ++k;
    const bool stays = k < now.size() && now[k] == old[i];
    if (stays)
      new_slots[k] = slots[i];
    if (next < contacts.pair.size() && contacts.pair[next] == static_cast<int>(i))
      contacts.pair[next++] = stays ? static_cast<int>(k) : -1;
  }
  slots.swap(new_slots);
}

/// Returns whether one block of a pair is a piece of a block that has split.
bool has_piece(const std::vector<char>& changed, const NearPair& pair) {
  return changed[static_cast<std::size_t>(pair.low)] != 0 ||
         changed[static_cast<std::size_t>(pair.high)] != 0;
}

/// Gives contacts of pieces pair number -1. Their arrays are out of date.
void drop_pieces(const std::vector<NearPair>& pairs, const std::vector<char>& changed,
                 ContactsOfPairs& contacts) {
  for (int& p : contacts.pair)
    if (p >= 0 && has_piece(changed, pairs[static_cast<std::size_t>(p)]))
      p = -1;
}

/// Reads the contacts of pieces from the list of the model.
void read_pieces(const Model& model, const std::vector<char>& changed,
                 const PairIndex& index, ContactsOfPairs& contacts) {
  std::vector<Contact> list;
  std::vector<LawState> states;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto [low, high] = pair_of(model.blocks, model.contacts[i]);
    if (!has_piece(changed, {low, high}))
      continue;
    list.push_back(model.contacts[i]);
    if (!model.law_states.empty())
      states.push_back(model.law_states[i]);
  }
  read_list(model.blocks, list, states, index, contacts);
}

/// Moves columns of blocks to huge pages. They are not read in order, so this saves
/// time.
void move_columns(const Blocks& blocks) {
  const auto move = [](const auto&... columns) {
    (dynamics::move_to_huge_pages(columns.data(),
                                  static_cast<std::size_t>(columns.size()) *
                                      sizeof *columns.data()),
     ...);
  };
  move(blocks.first_corner, blocks.corner_block, blocks.next, blocks.previous);
  move(blocks.arm, blocks.corner, blocks.centroid, blocks.velocity, blocks.force);
  move(blocks.area, blocks.mass, blocks.inertia, blocks.angle, blocks.spin,
       blocks.moment);
  move(blocks.second_moment, blocks.gradient, blocks.applied, blocks.stress,
       blocks.strain_rate);
}

/// Returns whether the arrays were made for the present number of blocks.
bool fits(const Workspace& work, const Blocks& blocks) {
  return work.index.neighbours.groups() == blocks.size();
}

}  // namespace

void update_pairs(Model& model, Workspace& work) {
  const Blocks& blocks = model.blocks;
  if (!model.kept.empty()) {
    if (work.springs.arrays_are_current() || work.springs.arrays_lack_pieces())
      model.kept = {};  // of a checkpoint that a step before has written
    else
      restore_decisions(model, work);
  }
  if (!work.contacts.laws.is_of(model.settings) ||
      !(fits(work, blocks) || work.springs.arrays_lack_pieces()))
    work.springs.list_changed();
  const bool blocks_split = work.springs.arrays_lack_pieces();
  const bool from_arrays = work.springs.arrays_are_current();
  const bool keeps = from_arrays || blocks_split;
  if (model.search.current && from_arrays)
    return;
  const Profile::Timer timer(work.profile, Profile::search);
  if (!model.search.current) {
    model.search.renew(list_tolerance(model));
    update_plane_contacts(model, work.plane_contacts, model.search.left);
  }
  std::vector<NearPair>& found = work.near_pairs;
  find_near_pairs(blocks, model.search.left, work.search, found);
  ContactsOfPairs contacts, of_pieces;
  if (keeps)
    work.contacts.copy_contacts(contacts);
  add_pairs(found, from_arrays ? pairs_with_springs(work.index, contacts)
                               : pairs_with_springs(blocks, model.contacts));
  std::swap(work.index, work.last_index);
  work.index.take(found, blocks.size());
  if (!from_arrays)
    work.parts.make(blocks);
  if (blocks_split) {
    read_pieces(model, work.changed_blocks, work.index, of_pieces);
    work.decisions.bounds.take_in(blocks, work.changed_blocks);
  }
  if (keeps) {
    renumber(work.last_index.pairs, work.index.pairs, contacts,
             work.contacts.slots_of_pair);
    if (blocks_split)
      drop_pieces(work.index.pairs, work.changed_blocks, contacts);
    work.decisions.keep_in(work.index, work.last_index, work.changed_blocks);
  } else {
    read_list(blocks, model.contacts, model.law_states, work.index, contacts);
    work.contacts.slots_of_pair.assign(work.index.pairs.size(), 0);
    work.decisions.bounds.start(blocks, model.settings.rigid);
    work.decisions.reset(work.index.size());
  }
  work.changed_blocks.clear();
  work.split.start(blocks.size(), work.index.pairs, pairs_of_window,
                   work.workers->threads());
  work.contacts.make(blocks, model.settings, work.index, contacts, of_pieces);
  work.split.split_batches(work.contacts.first_batch);
  if (!from_arrays)
    work.springs.both_agree();
  if (std::exchange(work.corners_in_huge_pages, blocks.corner.data()) !=
      blocks.corner.data())
    move_columns(blocks);
}

}  // namespace blocks::dynamics
