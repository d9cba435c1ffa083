#include "dynamics/give_back.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace blocks::dynamics {

void give_back_what_is_free() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace blocks::dynamics
