#include "dynamics/decisions/decide_contacts.hpp"

#include <utility>

namespace blocks::dynamics {

void join_changes(DecisionMemory& memory, std::vector<ReleasedSpring>& released) {
  memory.grown.clear();
  std::vector<std::pair<int, std::pair<const ContactsOfPairs*, int>>> order;
  for (DecisionThread& thread : memory.threads) {
    std::vector<ReleasedSpring>& own = thread.changes.released;
    released.insert(released.end(), own.begin(), own.end());
    own.clear();
    const ContactsOfPairs& some = thread.changes.grown;
    for (std::size_t k = 0; k < some.pair.size(); ++k)
      order.push_back({some.pair[k], {&some, static_cast<int>(k)}});
  }
  if (order.empty())
    return;
  // The pairs are sorted, so that their order does not depend on which thread found
  // them.
  std::sort(order.begin(), order.end());
  for (const auto& [p, from] : order) {
    const auto& [some, k] = from;
    memory.grown.add(*some, static_cast<std::size_t>(k));
  }
  for (DecisionThread& thread : memory.threads)
    thread.changes.grown.clear();
}

}  // namespace blocks::dynamics
