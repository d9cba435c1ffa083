// Prints the hash of the first layers of every family. Built by several compilers and
// at several levels of optimisation, it has to print the same.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "validation/robustness/layer_hash.hpp"

int main(int argc, char** argv) {
  const int layers = argc > 1 ? std::atoi(argv[1]) : 24;
  for (const auto& family : blocks::robustness::families()) {
    const int count = family.weight < 10 ? 2 : layers;
    std::printf("%016" PRIx64 " %s\n", blocks::robustness::hash_of(family, count),
                std::string(family.name).c_str());
  }
}
