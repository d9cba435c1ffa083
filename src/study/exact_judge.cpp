#include "study/exact_judge.hpp"

#include <algorithm>

#include "dynamics/pair_decisions.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::study {

void ExactJudge::decide(const Model& model) {
  const Blocks& blocks = model.blocks;
  if (model.search.updates != seen_) {
    std::vector<dynamics::NearPair> found;
    dynamics::find_near_pairs(blocks, 2.0 * model.search.left, near_, found);
    const bool known = seen_ >= 0;  // The blocks have only moved since then.
    all_.take(found, blocks, model.settings.rigid, 1, known, known);
    seen_ = model.search.updates;
  }
  acting_.clear();
  for (int p = 0; p < static_cast<int>(all_.pairs.size()); ++p) {
    dynamics::ContactRules::decide(blocks, all_, p, scratch_);
    for (const dynamics::CornerOnEdge& at : scratch_.found)
      acting_.emplace_back(all_.pairs[p].low, all_.pairs[p].high, at.corner, at.edge);
  }
  std::sort(acting_.begin(), acting_.end());
}

void ExactJudge::compare(const Blocks& blocks, const Contacts& contacts,
                         Outcome& outcome) const {
  auto exact = acting_.begin();
  long right = 0, acted = 0;
  for (int i = 0; i < contacts.size(); ++i) {
    if (!contacts.active[i])
      continue;
    ++acted;
    const auto [low, high] = pair_of(blocks, contacts, i);
    const Key key(low, high, contacts.corner[i], contacts.edge[i]);
    while (exact != acting_.end() && *exact < key)
      ++exact;
    right += exact != acting_.end() && *exact == key;
  }
  outcome.acting += acted;
  outcome.phantom += acted - right;
  outcome.exact += static_cast<long>(acting_.size());
  outcome.missed += static_cast<long>(acting_.size()) - right;
}

}  // namespace blocks::study
