#include "geometry/random.hpp"

#include <Random123/philox.h>

namespace blocks::geometry {

std::uint64_t random_53_bits(StreamKey key, std::uint64_t block, std::uint32_t draw,
                             std::uint32_t use) {
  const r123::Philox4x64::ctr_type counter = {{block, draw, use, 0}};
  const r123::Philox4x64::key_type words = {{key.seed, key.layer}};
  return r123::Philox4x64()(counter, words)[0] >> 11U;
}

}  // namespace blocks::geometry
