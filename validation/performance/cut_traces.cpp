// Cuts a square by N random traces and prints the number of cells. The benchmark runs
// it as a program of its own to measure its memory.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "geometry/cut.hpp"

int main(int argc, char** argv) {
  using namespace blocks::geometry;
  const int count = argc == 2 ? std::atoi(argv[1]) : 0;
  if (count < 1) {
    std::fprintf(stderr, "blocks: error: usage: cut_traces NUMBER\n");
    return 2;
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  CutRequest cuts;
  cuts.outline = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  // Traces of three mean distances, so that the number of crossings of each is the same
  // for any number of traces.
  const double half = 1.5 / std::sqrt(count);
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * part(random);
    const Vec2 d(half * std::cos(angle), half * std::sin(angle));
    const double x = part(random);
    const Vec2 p(x, part(random));
    cuts.joints.push_back({Vec2(p - d), Vec2(p + d), 1 + i % 3});
  }
  std::printf("%zu cells\n", cut_outline(cuts).mesh.cells.size());
  return 0;
}
