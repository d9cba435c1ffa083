// A hash of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace blocks::files {

/// The FNV-1a hash, 64 bits.
class Fnv1a {
 public:
  void add(const void* data, std::size_t size) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
      state_ = (state_ ^ byte[i]) * 0x100000001B3ULL;
  }
  std::uint64_t value() const { return state_; }
  /// The hash as 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

}  // namespace blocks::files
