// One hash for the bits of many layers, to compare builds.
#pragma once

#include <bit>
#include <cstdint>

#include "validation/geometry/families.hpp"

namespace blocks::validation {

/// FNV-1a over the bytes of 64-bit words.
class BitHash {
 public:
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8)
      value_ = (value_ ^ ((word >> shift) & 0xffU)) * 0x100000001b3ULL;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// Adds the vertices, cells and counts of one layer, or the kind of its refusal.
inline void add_layer(BitHash& hash, const geometry::LayerRequest& request) {
  try {
    const geometry::Layer layer = geometry::cut_layer(request);
    for (const auto& v : layer.mesh.vertices) {
      hash.add(v.x());
      hash.add(v.y());
    }
    for (const auto& cell : layer.mesh.cells)
      for (const int corner : cell)
        hash.add(static_cast<std::uint64_t>(corner));
    hash.add(static_cast<std::uint64_t>(layer.redrawn));
    hash.add(static_cast<std::uint64_t>(layer.ruled));
    for (const auto& a : layer.absorptions) {
      hash.add(static_cast<std::uint64_t>(a.into));
      hash.add(a.width_to_height);
    }
  } catch (const geometry::LayerError& error) {
    hash.add(~static_cast<std::uint64_t>(error.kind));
  }
}

/// Returns the hash of the first `layers` layers of a family.
inline std::uint64_t hash_of(const Family& family, int layers) {
  BitHash hash;
  for (int number = 0; number < layers; ++number)
    add_layer(hash, family.make(static_cast<std::uint64_t>(number)));
  return hash.value();
}

}  // namespace blocks::validation
