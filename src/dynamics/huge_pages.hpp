// Large columns in large pages of memory: a step goes to some hundred places of each
// block, and the processor keeps account of few pages.
#pragma once

#include <cstddef>

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// What is written to these bytes from now on is to stand in huge pages, where the
/// system has some. Little memory stays as it is.
void prefer_huge_pages(const void* first, std::size_t bytes);

/// The columns of these blocks, which are moved there.
void move_to_huge_pages(const Blocks& blocks);

}  // namespace blocks::dynamics
