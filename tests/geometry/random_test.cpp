#include "geometry/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace blocks::geometry {
namespace {

TEST(RandomStream, HasAnotherNumberForEveryKey) {
  std::set<std::uint64_t> seen;
  int names = 0;
  for (std::uint64_t seed : {0, 1})
    for (std::uint64_t layer : {0, 1, 2})
      for (std::uint64_t block = 0; block < 50; ++block)
        for (std::uint32_t draw : {0U, 1U})
          for (std::uint32_t use : {0U, 1U}) {
            seen.insert(random_53_bits({seed, layer}, block, draw, use));
            ++names;
          }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(names));
}

TEST(RandomStream, IsUniformOverItsRange) {
  // Each of 16 bins expects 1000. Chi-square with 15 degrees of freedom exceeds 45 once
  // in 10^4.
  std::array<int, 16> bins{};
  for (std::uint64_t block = 0; block < 16000; ++block) {
    const std::uint64_t bits = random_53_bits({7, 3}, block, 0, 0);
    ASSERT_LT(bits, std::uint64_t{1} << 53U);
    ++bins[static_cast<std::size_t>(bits >> 49U)];
  }
  double chi_square = 0.0;
  for (const int count : bins)
    chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
  EXPECT_LT(chi_square, 45.0);
}

TEST(RandomStream, IsThePublishedPhilox4x64) {
  // This is the known answer of the Random123 distribution for counter and key zero and
  // ten rounds.
  EXPECT_EQ(random_53_bits({0, 0}, 0, 0, 0), 0x16554d9eca36314cULL >> 11U);
}

}  // namespace
}  // namespace blocks::geometry
