#include "dynamics/contacts/contact_list.hpp"

#include <cstddef>
#include <utility>

namespace blocks::dynamics {

void read_list(const Blocks& blocks, const std::vector<Contact>& list,
               const std::vector<LawState>& states, const PairIndex& index,
               ContactsOfPairs& all) {
  all.clear();
  std::vector<PairContact> own;
  int p = 0;
  auto next = list.begin();
  while (next != list.end()) {
    const auto wanted = pair_of(blocks, *next);
    own.clear();
    for (; next != list.end() && pair_of(blocks, *next) == wanted; ++next) {
      own.push_back({{.at = {next->corner, next->edge},
                      .acted = true,
                      .normal = next->normal_elastic,
                      .shear = next->shear_elastic}});
      if (!states.empty())
        own.back().law_state = states[static_cast<std::size_t>(next - list.begin())];
    }
    const auto blocks_of = [&] {
      return std::pair(index.pairs[p].low, index.pairs[p].high);
    };
    while (p < index.size() && blocks_of() < wanted)
      ++p;
    if (p < index.size() && blocks_of() == wanted)
      all.add(p, own, !states.empty());
  }
}

}  // namespace blocks::dynamics
