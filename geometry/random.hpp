// Counter-based, portable, seeded random streams (Philox 4x64): order-free, keyed by
// (seed, layer, block), so that adding a layer does not change the others
// (stream_of in layer.hpp names a layer).
#pragma once

#include <cstdint>

namespace blocks::geometry {

/// Names one stream. The same key gives the same numbers on every machine.
struct StreamKey {
  std::uint64_t seed = 0;
  std::uint64_t layer = 0;
};

/// A whole number, uniform in [0, 2^53): the caller scales it exactly.
/// block: which block of the layer; draw: which redraw of it; use: what it is for.
std::uint64_t random_53_bits(StreamKey key, std::uint64_t block, std::uint32_t draw,
                             std::uint32_t use);

}  // namespace blocks::geometry
