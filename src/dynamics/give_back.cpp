#include "dynamics/give_back.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace blocks::dynamics {
namespace {

/// The pages that lie wholly between two places.
void give_back_pages([[maybe_unused]] std::byte* first,
                     [[maybe_unused]] std::byte* last) {
#ifdef __linux__
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before =
      (page - reinterpret_cast<std::uintptr_t>(first) % page) % page;
  const std::size_t after = reinterpret_cast<std::uintptr_t>(last) % page;
  madvise(first + before, static_cast<std::size_t>(last - first) - before - after,
          MADV_DONTNEED);
#endif
}

}  // namespace

void give_back_what_is_free() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void Wake::passed(void* place) {
  auto* const here = static_cast<std::byte*>(place);
  if (here - front_ < static_cast<std::ptrdiff_t>(little_memory))
    return;
  give_back_pages(front_, here);
  front_ = here;
}

}  // namespace blocks::dynamics
