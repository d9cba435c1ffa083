// What a new decision changes in the slots of a pair.
#include <algorithm>
#include <cstddef>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/contacts/partners.hpp"

namespace blocks::dynamics {
namespace {

/// Writes the contacts in ascending order of corner and edge, without springs.
void sort_contacts(const std::vector<CornerOnEdge>& found, bool tested,
                   std::vector<PairContact>& sorted) {
  sorted.clear();
  for (const CornerOnEdge& at : found)
    sorted.push_back({{.at = at, .tested = tested, .certain = !tested}});
  std::sort(sorted.begin(), sorted.end(),
            [](const PairContact& l, const PairContact& r) { return l.at < r.at; });
}

/// Adds the contacts of `before` that may be held to `now`.
void keep_held(std::vector<PairContact>& now, const std::vector<PairContact>& before) {
  for (const PairContact& old : before)
    if (old.may_be_held())
      add_in_order(now, old.at);
}

/// Removes contacts that are not bonded and whose corner is bonded to another edge of
/// the block, whether the rule has found them, an offset would hold them, or they are
/// partners. At a bend of a bonded joint a corner may be bonded to two edges.
void drop_beside_bonds(std::vector<PairContact>& now,
                       const std::vector<PairContact>& before) {
  std::erase_if(now, [&](const PairContact& one) {
    bool is_beside = false;
    for (const PairContact& old : before)
      if (old.acted && old.law_state.bonded && old.at.corner == one.at.corner) {
        if (old.at == one.at)
          return false;
        is_beside = true;
      }
    return is_beside;
  });
}

}  // namespace

void ContactArrays::assign(const Blocks& blocks, const PairIndex& index, int p,
                           const std::vector<CornerOnEdge>& found, bool tested,
                           ContactChanges& changes) {
  std::vector<PairContact>& now = changes.now;
  sort_contacts(found, tested, now);
  const std::vector<PairContact>& before = changes.before;
  const bool may_hold = laws.may_act(blocks, index.pairs[p].low, index.pairs[p].high);
  if (may_hold) {
    contacts_of(p, changes.before);
    keep_held(now, before);
    drop_beside_bonds(now, before);
    if (laws.in_situ()) {
      add_partners(blocks, now);
      drop_beside_bonds(now, before);
    }
  }
  bool same = true;
  std::size_t slots = 0;
  each_slot(p, [&](int slot) {
    same = same && (slots < now.size() ? at(slot) == now[slots].at : is_vacant(slot));
    ++slots;
  });
  const bool fits = now.size() <= slots;
  std::size_t k = 0;
  if (same && fits) {
    each_slot(p, [&](int slot) {
      batches.set(slot, &ContactTests::tested, k < now.size() && now[k].tested);
      batches.set(slot, &ContactTests::certain, k < now.size() && now[k].certain);
      ++k;
    });
    return;
  }
  if (!may_hold)
    contacts_of(p, changes.before);
  auto next = now.begin();
  for (const PairContact& old : before) {
    while (next != now.end() && next->at < old.at)
      ++next;
    if (next != now.end() && next->at == old.at)
      next->acted = old.acted, next->normal = old.normal, next->shear = old.shear,
      next->law_state = old.law_state;
    else if (old.normal > 0.0)
      changes.released.push_back({p, old.at, old.normal, old.shear, old.law_state});
  }
  if (!fits) {
    changes.grown.add(p, now, !laws.none());
    return;
  }
  each_slot(p, [&](int slot) {
    fill_slot(blocks, index.pairs[p].low, slot,
              k < now.size() ? now[k] : PairContact{});
    ++k;
  });
  if (has_laws(p))
    find_partners(blocks, p);
}

}  // namespace blocks::dynamics
