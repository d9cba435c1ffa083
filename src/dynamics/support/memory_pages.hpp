// Requests huge pages for large columns and returns freed memory to the system. These
// functions change run time and memory use, never results.
#pragma once

#include <cstddef>

namespace blocks::dynamics {

/// Asks the system to use huge pages for these bytes when they are first written.
void prefer_huge_pages(const void* first, std::size_t bytes);

/// Moves these bytes, which have been written, into huge pages where the system can.
void move_to_huge_pages(const void* first, std::size_t bytes);

/// Returns to the system the memory that the program has freed but the allocator still
/// holds.
void release_free_pages();

}  // namespace blocks::dynamics
