// The bits of generated layers: the same from every compiler, at every level of
// optimisation, in every rounding mode and whatever else has been generated.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>

#include "layers.hpp"
#include "validation/robustness/layer_hash.hpp"

namespace blocks::geometry {
namespace {

using robustness::families;
using robustness::hash_of;

// First 24 layers of each family (2 of the family with 2000 blocks). A change here
// changes the blocks that users get from the same deck and seed.
constexpr std::array<std::uint64_t, 11> golden = {
    0x2f04fae3354b3f9c, 0x6b4777392ec30659, 0xc08e7f391fccb4a0, 0x6fabb3a2ddb5f6df,
    0x7f917a46d91c6a81, 0x5e1c2ac092892da8, 0x109aa2c52ba8fe75, 0x22eb79402c78bcaf,
    0xd05cbb0dbfc7d482, 0x7b3955c0d5b6f7c8, 0xfaf02f7ca7dbd965};

std::array<std::uint64_t, 11> hashes(int layers) {
  std::array<std::uint64_t, 11> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& family = families()[i];
    result[i] = hash_of(family, family.weight < 10 ? 2 : layers);
  }
  return result;
}

// Restores rounding to nearest when a test leaves, however it leaves.
class RoundingMode {
 public:
  explicit RoundingMode(int mode) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(FE_TONEAREST); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;
};

TEST(GoldenLayers, KeepTheirBits) {
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

// Streams are keyed by (seed, layer, block): neither the order of generation nor a new
// layer in between changes a layer.
TEST(GoldenLayers, KeepTheirBitsWhateverElseIsGenerated) {
  const auto make = [](std::uint64_t layer) {
    LayerRequest request =
        testing::random_layer("0.1 0.2 0.1 1.3 40.7 3.1 40.7 2", 40, "-30", "30");
    request.stream = {3, layer};
    return request;
  };
  const auto bits = [&](std::uint64_t layer) {
    robustness::BitHash hash;
    robustness::add_layer(hash, make(layer));
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
