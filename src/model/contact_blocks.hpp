// Whose a record of the list of contacts is.
#pragma once

#include <algorithm>
#include <utility>

#include "model/blocks.hpp"
#include "model/contacts.hpp"

namespace blocks {

/// The blocks of record i, the lower number first.
inline std::pair<int, int> pair_of(const Blocks& blocks, const Contacts& contacts,
                                   int i) {
  const int a = blocks.corner_block[contacts.corner[i]];
  const int b = blocks.corner_block[contacts.edge[i]];
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace blocks
