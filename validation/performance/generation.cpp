#include "generation.hpp"

#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/layer.hpp"

namespace blocks::bench {
namespace {

using namespace geometry;

Decimal decimal(const std::string& text) { return *Decimal::parse(text); }

// Requests a layer of height 1 and length 1 per block with ORIENT +-10, or a slanted
// trapezoid of that size.
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

}  // namespace

GenerationCost cost_of_layers(int layers, int blocks, bool slanted) {
  std::vector<Layer> made;
  made.reserve(static_cast<std::size_t>(layers));
  const std::clock_t start = std::clock();  // Processor time: machines are shared.
  for (int k = 0; k < layers; ++k)
    made.push_back(cut_layer(layer_of(blocks, slanted, static_cast<std::uint64_t>(k))));
  const std::clock_t cut = std::clock();
  bool hold = true;
  for (const Layer& layer : made)
    hold = certify_tiling(layer.mesh).holds && hold;
  const std::clock_t end = std::clock();
  if (!hold)
    throw std::runtime_error("a certificate of a random layer does not hold");
  const double total = static_cast<double>(layers) * blocks;
  const auto each = [total](std::clock_t ticks) {
    return 1e9 * static_cast<double>(ticks) / CLOCKS_PER_SEC / total;
  };
  return {each(cut - start), each(end - cut)};
}

}  // namespace blocks::bench
