// Random numbers of one frame of a study, the same on every machine.
#pragma once

#include <cstdint>

#include "geometry/random.hpp"

namespace blocks::study {

/// The numbers of one frame, each drawn once.
class Draws {
 public:
  /// number: that of the frame; stream: 0 for the frame itself, 1 for the blocks of a
  /// scene that differs from frame to frame.
  Draws(std::uint64_t seed, int number, std::uint64_t stream = 0)
      : key_{seed, stream}, number_(number) {}
  /// Uniform in [0, 1).
  double operator()() {
    const auto bits =
        geometry::random_53_bits(key_, static_cast<std::uint64_t>(number_), 0, use_++);
    return static_cast<double>(bits) * 0x1p-53;
  }
  /// Uniform in [low, high).
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  int below(int n) { return static_cast<int>((*this)() * n); }

 private:
  geometry::StreamKey key_;
  int number_;
  std::uint32_t use_ = 0;
};

}  // namespace blocks::study
