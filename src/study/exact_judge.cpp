#include "study/exact_judge.hpp"

#include <algorithm>

#include "dynamics/decisions/contact_rule.hpp"

namespace blocks::study {

void ExactJudge::decide(const Model& model) {
  const Blocks& blocks = model.blocks;
  if (model.search.updates != seen_) {
    std::vector<dynamics::NearPair> found;
    dynamics::find_near_pairs(blocks, 2.0 * model.search.left, near_, found);
    if (seen_ < 0)
      parts_.make(blocks);
    index_.take(found, blocks.size());
    seen_ = model.search.updates;
  }
  acting_.clear();
  for (int p = 0; p < index_.size(); ++p) {
    dynamics::exact_rule().decide(blocks, parts_, index_, p, scratch_);
    for (const dynamics::CornerOnEdge& at : scratch_.found)
      acting_.emplace_back(index_.pairs[p].low, index_.pairs[p].high, at.corner,
                           at.edge);
  }
  std::sort(acting_.begin(), acting_.end());
}

void ExactJudge::compare(const Blocks& blocks, const std::vector<Contact>& contacts,
                         Outcome& outcome) const {
  auto exact = acting_.begin();
  const long acted = static_cast<long>(contacts.size());
  long right = 0;
  for (const Contact& contact : contacts) {
    const Key key = sort_key(blocks, contact);
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
