// Items in groups, such as the pairs of each block or the blocks of each cell.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace blocks::dynamics {

/// The items of group g are the half-open range from item[first[g]] to
/// item[first[g + 1]].
struct Groups {
  std::vector<int> first;  ///< (groups + 1)
  std::vector<int> item;

  /// Sorts items into groups (counting sort). Within a group they keep the order in
  /// which they were added. each(add) has to call add(group, item) for every item; it
  /// is called twice.
  template <class Each> void sort(int groups, const Each& each) {
    first.assign(static_cast<std::size_t>(groups) + 1, 0);
    each([&](int group, int) { ++first[group + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    item.resize(static_cast<std::size_t>(first.back()));
    each([&](int group, int which) { item[first[group]++] = which; });
    // Each entry has advanced to the beginning of the next group.
    std::move_backward(first.begin(), first.end() - 1, first.end());
    first[0] = 0;
  }
  int count(int group) const { return first[group + 1] - first[group]; }
  int groups() const { return static_cast<int>(first.size()) - 1; }
  /// Calls visit(item) for each item of a group.
  template <class Visit> void each(int group, const Visit& visit) const {
    for (int k = first[group]; k < first[group + 1]; ++k)
      visit(item[k]);
  }
};

}  // namespace blocks::dynamics
