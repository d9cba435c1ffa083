// Times of the time loop: ./go bench.
#include <cstdio>

#include "blocks_code.hpp"
#include "timing.hpp"
#include "wall.hpp"

int main() {
  using namespace blocks::bench;
  std::printf("| blocks | ns a block-step | steps of a round |\n|---|---|---|\n");
  for (int power = 3; power <= 5; ++power) {
    BlocksCode code(wall_of_power(power));
    const Times times = take_turns({&code}, 5, 0.2).front();
    std::printf("| %.0f | %.1f | %ld |\n", code.work_per_step(), times.middle(),
                times.steps);
  }
}
