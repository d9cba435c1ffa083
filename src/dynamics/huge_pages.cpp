#include "dynamics/huge_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace blocks::dynamics {
namespace {

/// Calls act(first, bytes) for the huge pages that lie wholly between two places.
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

void move_to_huge_pages(const Blocks& blocks) {
#ifdef MADV_HUGEPAGE
#ifdef MADV_COLLAPSE
  constexpr int collapse = MADV_COLLAPSE;
#else
  constexpr int collapse = 25;  // of Linux 6.1; without it nothing is moved
#endif
  const auto move = [](const auto& column) {
    const std::size_t bytes =
        static_cast<std::size_t>(column.size()) * sizeof *column.data();
    prefer_huge_pages(column.data(), bytes);
    huge_pages(column.data(), bytes,
               [](void* from, std::size_t all) { madvise(from, all, collapse); });
  };
  for (const auto* column :
       {&blocks.first_corner, &blocks.corner_block, &blocks.next, &blocks.previous})
    move(*column);
  for (const auto* column :
       {&blocks.arm, &blocks.corner, &blocks.centroid, &blocks.velocity, &blocks.force})
    move(*column);
  for (const auto* column : {&blocks.area, &blocks.mass, &blocks.inertia, &blocks.angle,
                             &blocks.spin, &blocks.moment})
    move(*column);
  for (const auto* column : {&blocks.applied, &blocks.stress, &blocks.strain_rate})
    move(*column);
#endif
}

}  // namespace blocks::dynamics
