// Copies contacts between the arrays of a step and the list of the model
// (Model::contacts).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"
#include "model/contacts.hpp"

namespace blocks::dynamics {

/// Reads the contacts of the list. They count as acting in the step before. Contacts of
/// pairs that are not in the index are left out. states: those of the laws, (list) or
/// empty.
void read_list(const Blocks& blocks, const std::vector<Contact>& list,
               const std::vector<LawState>& states, const PairIndex& index,
               ContactsOfPairs& all);

/// Lists the acting contacts in the order of the pairs, on all threads. put(slot,
/// contact) writes the entry of a slot, except corner and edge. If joints have laws, it
/// also lists their states; otherwise there are none. first: working memory.
template <class Put>
void list_acting(const ContactArrays& arrays, const WorkSplit& split, Workers& workers,
                 std::vector<int>& first, std::vector<Contact>& list,
                 std::vector<LawState>& states, const Put& put) {
  const ContactBatches& batches = arrays.batches;
  first.assign(arrays.first_batch.size(), 0);
  workers.each(split.windows, [&](int, int begin, int end) {
    for (int window = begin; window < end; ++window)
      for (int batch = arrays.first_batch[window];
           batch < arrays.first_batch[window + 1]; ++batch)
        for (int i = 0; i < batches.pairs[batch].rows; ++i)
          first[window + 1] +=
              std::popcount(batches.states[batches.pairs[batch].first_row + i].acts);
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  const auto count = static_cast<std::size_t>(first.back());
  const int pairs = static_cast<int>(arrays.lane_of_pair.size());
  const bool has_states = !arrays.laws.none();
  list.resize(count);
  states.resize(has_states ? count : 0);
  workers.each(split.windows, [&](int, int begin, int end) {
    for (int window = begin; window < end; ++window) {
      auto i = static_cast<std::size_t>(first[window]);
      const int last = std::min(pairs, (window + 1) * pairs_of_window);
      for (int p = window * pairs_of_window; p < last; ++p)
        arrays.each_slot(p, [&](int slot) {
          if (!batches.is(slot, &ContactStates::acts))
            return;
          list[i].corner = arrays.at(slot).corner, list[i].edge = arrays.at(slot).edge;
          put(slot, list[i]);
          if (has_states)
            states[i] = arrays.law_state_at(slot);
          ++i;
        });
    }
  });
}

}  // namespace blocks::dynamics
