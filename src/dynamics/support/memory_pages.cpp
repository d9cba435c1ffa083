#include "dynamics/support/memory_pages.hpp"

#include <cstdint>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace blocks::dynamics {
namespace {

/// Calls act(first, bytes) for the range of whole huge pages within the given bytes.
template <class Act>
void huge_pages(const void* first, std::size_t bytes, const Act& act) {
  constexpr std::uintptr_t size = std::uintptr_t{1} << 21;
  const auto begin = reinterpret_cast<std::uintptr_t>(first);
  const std::uintptr_t from = (begin + size - 1) / size * size;
  const std::uintptr_t to = (begin + bytes) / size * size;
  if (to > from)
    act(reinterpret_cast<void*>(from), to - from);
}

}  // namespace

void prefer_huge_pages([[maybe_unused]] const void* first,
                       [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  huge_pages(first, bytes,
             [](void* from, std::size_t all) { madvise(from, all, MADV_HUGEPAGE); });
#endif
}

void move_to_huge_pages([[maybe_unused]] const void* first,
                        [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
#ifdef MADV_COLLAPSE
  constexpr int collapse = MADV_COLLAPSE;
#else
  constexpr int collapse = 25;  // MADV_COLLAPSE of Linux 6.1; older systems refuse it
#endif
  prefer_huge_pages(first, bytes);
  huge_pages(first, bytes,
             [](void* from, std::size_t all) { madvise(from, all, collapse); });
#endif
}

void release_free_pages() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace blocks::dynamics
