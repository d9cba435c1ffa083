#include "dynamics/kept_state.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "dynamics/contacts/contact_list.hpp"

namespace blocks::dynamics {
namespace {

// A limit may be infinite; a checkpoint contains finite numbers.
constexpr double infinite = std::numeric_limits<double>::infinity(),
                 largest = std::numeric_limits<double>::max();

/// Returns the contacts of a kept pair: all that may act, with the springs of those
/// that did.
std::vector<PairContact> with_springs(const KeptContact* first, int count,
                                      const ContactsOfPairs& listed, std::size_t k) {
  std::vector<PairContact> all;
  for (const KeptContact* one = first; one != first + count; ++one)
    all.push_back({{.at = {one->corner, one->edge},
                    .tested = one->tested,
                    .certain = one->certain}});
  if (k == listed.pair.size())
    return all;
  for (int i = listed.first[k]; i < listed.first[k + 1]; ++i) {
    const PairContact acted = listed.at(static_cast<std::size_t>(i));
    const auto place =
        std::find_if(all.begin(), all.end(),
                     [&](const PairContact& one) { return one.at == acted.at; });
    if (place == all.end())
      continue;
    place->acted = true;
    place->normal = acted.normal, place->shear = acted.shear;
    place->law_state = acted.law_state;
  }
  return all;
}

}  // namespace

KeptDecisions kept_decisions(const Workspace& work) {
  KeptDecisions kept;
  const Decisions& decisions = work.decisions;
  const ContactArrays& arrays = work.contacts;
  kept.pairs.reserve(work.index.pairs.size());
  for (int p = 0; p < work.index.size(); ++p) {
    const auto [low, high] = work.index.pairs[p];
    const std::size_t before = kept.contacts.size();
    arrays.each_slot(p, [&](int slot) {
      // Contacts of blocks that have split have no corner.
      if (!arrays.is_vacant(slot) && arrays.at(slot).corner >= 0 &&
          arrays.at(slot).edge >= 0)
        kept.contacts.push_back({arrays.at(slot).corner, arrays.at(slot).edge,
                                 arrays.batches.is(slot, &ContactTests::tested),
                                 arrays.batches.is(slot, &ContactTests::certain)});
    });
    const Renewal none, *const stored = decisions.pairs[p].renewal.get();
    const auto& [poses, depths] = stored != nullptr ? *stored : none;
    kept.poses.insert(kept.poses.end(), poses.begin(), poses.end());
    kept.depths.insert(kept.depths.end(), depths.begin(), depths.end());
    Validity validity = decisions.pairs[p].validity;
    validity.distance = std::min(validity.distance, largest);
    validity.until = std::min(validity.until, largest);
    kept.pairs.push_back(
        {low, high, validity, static_cast<int>(kept.contacts.size() - before),
         static_cast<int>(poses.size()), static_cast<int>(depths.size())});
  }
  for (std::size_t b = 0; b < work.changed_blocks.size(); ++b)
    if (work.changed_blocks[b] != 0)
      kept.pieces.push_back(static_cast<int>(b));
  kept.longest_path = decisions.bounds.longest_path;
  kept.blocks = static_cast<int>(decisions.bounds.longest.size());
  return kept;
}

void restore_decisions(Model& model, Workspace& work) {
  const KeptDecisions kept = std::exchange(model.kept, {});
  const Blocks& blocks = model.blocks;
  std::vector<NearPair> pairs;
  for (const KeptPair& pair : kept.pairs)
    pairs.push_back({pair.low, pair.high});
  work.index.take(pairs, kept.blocks);
  work.parts.make(blocks);
  Decisions& decisions = work.decisions;
  decisions.bounds.start(blocks, model.settings.rigid);
  decisions.bounds.longest_path = kept.longest_path;
  decisions.reset(work.index.size());
  ContactsOfPairs listed, contacts;
  read_list(blocks, model.contacts, model.law_states, work.index, listed);
  std::size_t k = 0;
  const KeptContact* contact = kept.contacts.data();
  auto pose = kept.poses.begin();
  auto depth = kept.depths.begin();
  for (int p = 0; p < work.index.size(); ++p) {
    const KeptPair& pair = kept.pairs[static_cast<std::size_t>(p)];
    const auto limit = [](double stored) {
      return stored < largest ? stored : infinite;
    };
    decisions.pairs[p].validity = {limit(pair.validity.distance),
                                   limit(pair.validity.until), pair.validity.pose};
    if (pair.poses > 0)
      decisions.pairs[p].renewal = std::make_unique<Renewal>(
          Renewal{{pose, pose + pair.poses}, {depth, depth + pair.depths}});
    pose += pair.poses, depth += pair.depths;
    const bool has_listed = k < listed.pair.size() && listed.pair[k] == p;
    if (pair.contacts > 0)
      contacts.add(p,
                   with_springs(contact, pair.contacts, listed,
                                has_listed ? k : listed.pair.size()),
                   !model.law_states.empty());
    contact += pair.contacts;
    k += has_listed;
  }
  work.contacts.slots_of_pair.assign(work.index.pairs.size(), 0);
  work.split.start(blocks.size(), work.index.pairs, pairs_of_window,
                   work.workers->threads());
  work.contacts.make(blocks, model.settings, work.index, contacts, {});
  work.split.split_batches(work.contacts.first_batch);
  work.changed_blocks.clear();
  if (kept.pieces.empty())
    return work.springs.both_agree();
  work.changed_blocks.assign(static_cast<std::size_t>(blocks.size()), 0);
  for (const int b : kept.pieces)
    work.changed_blocks[static_cast<std::size_t>(b)] = 1;
  work.springs.blocks_split();
}

}  // namespace blocks::dynamics
