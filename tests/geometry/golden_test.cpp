// Generated layers have the same bits from every compiler, at every level of
// optimisation and in every rounding mode.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>

#include "layers.hpp"
#include "validation/geometry/layer_hash.hpp"

namespace blocks::geometry {
namespace {

using validation::families;
using validation::hash_of;

// Hashes of the first 24 layers of each family (2 of the family with 2000 blocks). If
// one of them changes, users get other blocks from the same deck and seed.
constexpr std::array<std::uint64_t, 11> golden = {
    0x2f04fae3354b3f9c, 0xb9983f65d7400ccc, 0x123ded24cfb75435, 0x9fd4d272ab5925e1,
    0x4441b2e6dea333e2, 0x77512e6d6701561d, 0x87c762a84c159ac8, 0xd2f0453f573c0f7e,
    0xed6c9c00aa0aa6fd, 0x5180dbe5ae85ea36, 0xfaf02f7ca7dbd965};

std::array<std::uint64_t, 11> hashes(int layers) {
  std::array<std::uint64_t, 11> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& family = families()[i];
    result[i] = hash_of(family, family.weight < 10 ? 2 : layers);
  }
  return result;
}

/// Sets a rounding mode and restores rounding to nearest on destruction.
class RoundingMode {
 public:
  explicit RoundingMode(int mode) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(FE_TONEAREST); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;
};

TEST(GoldenLayers, HaveTheRecordedBits) {
  ASSERT_EQ(families().size(), golden.size());
  const auto found = hashes(24);
  for (std::size_t i = 0; i < golden.size(); ++i)
    EXPECT_EQ(found[i], golden[i]) << families()[i].name;
}

TEST(GoldenLayers, DoNotDependOnTheRoundingModeOfTheCaller) {
  const auto expected = hashes(4);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::array<std::uint64_t, 11> found{};
    int left_behind = 0;
    {
      const RoundingMode caller(mode);
      found = hashes(4);
      left_behind = std::fegetround();
    }
    EXPECT_EQ(found, expected) << mode;
    EXPECT_EQ(left_behind, mode);
  }
}

// Random streams are keyed by (seed, layer, block).
TEST(GoldenLayers, DoNotDependOnTheOrderOfGeneration) {
  const auto make = [](std::uint64_t layer) {
    LayerRequest request =
        testing::random_layer("0.1 0.2 0.1 1.3 40.7 3.1 40.7 2", 40, "-30", "30");
    request.stream = {3, layer};
    return request;
  };
  const auto bits = [&](std::uint64_t layer) {
    validation::BitHash hash;
    validation::add_layer(hash, make(layer));
    return hash.value();
  };
  std::array<std::uint64_t, 5> forward{};
  for (std::uint64_t k = 0; k < 5; ++k)
    forward[k] = bits(k);
  for (std::uint64_t k = 5; k-- > 0;)
    EXPECT_EQ(bits(k), forward[k]) << k;
  for (std::uint64_t k = 1; k < 5; ++k)
    EXPECT_NE(forward[k], forward[0]) << k;
}

}  // namespace
}  // namespace blocks::geometry
