// Prints the hash of the first layers of every family. The output must be the same for
// every compiler and level of optimisation.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "validation/geometry/layer_hash.hpp"

int main(int argc, char** argv) {
  const int layers = argc > 1 ? std::atoi(argv[1]) : 24;
  for (const auto& family : blocks::validation::families()) {
    const int count = family.weight < 10 ? 2 : layers;
    std::printf("%016" PRIx64 " %s\n", blocks::validation::hash_of(family, count),
                std::string(family.name).c_str());
  }
}
