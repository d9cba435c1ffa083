// Time of generating random layers, by block: all of it and the certificate alone, from
// 10^3 to 10^6 blocks, as layers of 1000 and as one layer.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "geometry/layer.hpp"

namespace {

using namespace blocks::geometry;

Decimal decimal(const std::string& text) { return *Decimal::parse(text); }

// 1 high and one long for each block, ORIENT +-10; slanted: a turned trapezoid.
LayerRequest layer_of(int count, bool slanted, std::uint64_t number) {
  LayerRequest request;
  const std::string length = std::to_string(count);
  const Decimal end = decimal(length + ".7");
  if (slanted)
    request.corners = {{{decimal("0.1"), decimal("0.3")},
                        {decimal("0.1"), decimal("1.4")},
                        {end, decimal("34.7")},
                        {end, decimal("33.2")}}};
  else
    request.corners = {{{0, 0}, {0, 1}, {decimal(length), 1}, {decimal(length), 0}}};
  request.spacing = Spacing::random;
  request.count = count;
  request.angle_min = -10;
  request.angle_max = 10;
  request.stream = {1, number};
  return request;
}

struct Times {
  double all = 0.0;  // microseconds a block
  double certificate = 0.0;
};

Times measure(int layers, int blocks, bool slanted) {
  std::vector<Layer> made;
  made.reserve(static_cast<std::size_t>(layers));
  const std::clock_t start = std::clock();  // of the processor: machines are shared
  for (int k = 0; k < layers; ++k)
    made.push_back(cut_layer(layer_of(blocks, slanted, static_cast<std::uint64_t>(k))));
  const std::clock_t cut = std::clock();
  bool hold = true;
  for (const Layer& layer : made)
    hold = certify_tiling(layer.mesh).holds && hold;
  const std::clock_t end = std::clock();
  if (!hold)
    std::fprintf(stderr, "blocks: error: a certificate does not hold\n");
  const double total = static_cast<double>(layers) * blocks;
  const auto each = [total](std::clock_t ticks) {
    return 1e6 * static_cast<double>(ticks) / CLOCKS_PER_SEC / total;
  };
  return {each(cut - start), each(end - cut)};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"time of generating random layers"};
  int most = 1000000;
  app.add_option("--blocks", most, "largest number of blocks")
      ->check(CLI::Range(1000, 100000000));
  CLI11_PARSE(app, argc, argv);
  std::printf("one core, random spacing, ORIENT +-10; processor microseconds a block, "
              "all (of it the certificate)\n\n"
              "| blocks | layers of 1000 | slanted | one layer | slanted |\n"
              "|---|---|---|---|---|\n");
  for (int blocks = 1000; blocks <= most; blocks *= 10) {
    std::printf("| %d |", blocks);
    for (const int in_layer : {1000, blocks})
      for (const bool slanted : {false, true}) {
        const Times t = measure(blocks / in_layer, in_layer, slanted);
        std::printf(" %.1f (%.1f) |", t.all, t.certificate);
        std::fflush(stdout);
      }
    std::printf("\n");
  }
}
