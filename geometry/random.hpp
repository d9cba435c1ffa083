// Counter-based, portable, seeded random streams (Philox 4x64). Numbers do not depend
// on the order of the calls. The key is (seed, layer), so adding a layer does not
// change the others (stream_of in layer.hpp). The counter is (block, draw, use).
#pragma once

#include <cstdint>

namespace blocks::geometry {

/// Identifies one stream. The same key gives the same numbers on every machine.
struct StreamKey {
  std::uint64_t seed = 0;
  std::uint64_t layer = 0;
};

/// Returns an integer uniform in [0, 2^53), which the caller scales exactly. block:
/// number of the block in the layer. draw: number of the redraw. use: purpose of the
/// number, such as width or angle.
std::uint64_t random_53_bits(StreamKey key, std::uint64_t block, std::uint32_t draw,
                             std::uint32_t use);

}  // namespace blocks::geometry
