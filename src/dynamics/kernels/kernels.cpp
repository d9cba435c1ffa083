#include "dynamics/kernels/kernels.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace blocks::dynamics {

#define BLOCKS_DECLARE_KERNELS(name)                                                   \
  namespace name {                                                                     \
  extern const Kernels kernels;                                                        \
  }
BLOCKS_DECLARE_KERNELS(baseline)
#ifdef BLOCKS_X86_KERNELS
BLOCKS_DECLARE_KERNELS(avx2)
BLOCKS_DECLARE_KERNELS(avx512)
#endif

const std::vector<Kernels>& all_kernels() {
  static const std::vector<Kernels> all = [] {
    std::vector<Kernels> found = {baseline::kernels};
#ifdef BLOCKS_X86_KERNELS
    // The compiler may use x86-64-v3 and x86-64-v4 for these kernels (CMakeLists.txt).
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
    const bool v4 =
        v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl");
    if (v3)
      found.push_back(avx2::kernels);
    if (v4)
      found.push_back(avx512::kernels);
#endif
    return found;
  }();
  return all;
}

const Kernels& kernels() {
  static const Kernels chosen = [] {
    const char* name = std::getenv("BLOCKS_SIMD");
    if (name == nullptr)
      return all_kernels().back();
    std::string names;
    for (const Kernels& one : all_kernels()) {
      if (one.name == name)
        return one;
      names += (names.empty() ? "" : ", ") + std::string(one.name);
    }
    throw std::invalid_argument("BLOCKS_SIMD=" + std::string(name) +
                                " is no instruction set of this machine; there are " +
                                names);
  }();
  return chosen;
}

}  // namespace blocks::dynamics
