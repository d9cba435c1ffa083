#include "dynamics/decisions/decide_contacts.hpp"

#include <utility>

namespace blocks::dynamics {
namespace {

/// Two blocks nearer than this part of the shorter longest arm get slots before they
/// touch. In a pile that falls, the arrays are then rebuilt five times less often.
constexpr double near_share = 0.1;

}  // namespace

void expect_contacts(const PairIndex& index, const Decisions& decisions,
                     ContactArrays& arrays) {
  const std::vector<double>& longest = decisions.bounds.longest;
  for (int p = 0; p < index.size(); ++p) {
    const auto [low, high] = index.pairs[p];
    const double apart = decisions.rooms[p].motion;
    if (arrays.slots_of_pair[p] == 0 && apart > 0.0 &&
        apart < near_share * std::min(longest[low], longest[high]))
      arrays.slots_of_pair[p] = ContactArrays::contacts_of_two_faces;
  }
}

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
