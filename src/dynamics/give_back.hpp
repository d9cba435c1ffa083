// Memory that only a search needs.
#pragma once

#include <cstddef>
#include <vector>

namespace blocks::dynamics {

/// Empties the items and gives their memory back where it is much; a little stays, for
/// to ask for it at every search of a small model is slower.
template <class Item> void give_back(std::vector<Item>& items) {
  constexpr std::size_t little = std::size_t{1} << 22;  // bytes
  items.clear();
  if (items.capacity() * sizeof(Item) > little)
    items.shrink_to_fit();
}

}  // namespace blocks::dynamics
