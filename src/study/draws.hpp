// Random numbers of one frame of a study, identical on every machine.
#pragma once

#include <cstdint>

#include "geometry/random.hpp"

namespace blocks::study {

/// Generates the random numbers of one frame in sequence.
class Draws {
 public:
  /// `number` is the number of the frame. `stream` is 0 for the frame itself and 1 for
  /// the blocks of a scene that differs from frame to frame.
  Draws(std::uint64_t seed, int number, std::uint64_t stream = 0)
      : key_{seed, stream}, number_(number) {}
  /// Returns a number uniform in [0, 1).
  double operator()() {
    const auto bits =
        geometry::random_53_bits(key_, static_cast<std::uint64_t>(number_), 0, use_++);
    return static_cast<double>(bits) * 0x1p-53;
  }
  /// Returns a number uniform in [low, high).
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  int below(int n) { return static_cast<int>((*this)() * n); }

 private:
  geometry::StreamKey key_;
  int number_;
  std::uint32_t use_ = 0;
};

}  // namespace blocks::study
