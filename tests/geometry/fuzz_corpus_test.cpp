// What fuzzing found worth keeping, once more: fuzz_layer aborts if a layer comes back
// that is not certified.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

TEST(FuzzedLayers, OfTheCorpusAreCertifiedOrRefused) {
  int inputs = 0;
  for (const auto& file : std::filesystem::directory_iterator(
           BLOCKS_SOURCE_DIR "/tests/geometry/fuzz_layer_corpus")) {
    std::ifstream in(file.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
    EXPECT_EQ(LLVMFuzzerTestOneInput(data.data(), data.size()), 0);
    ++inputs;
  }
  EXPECT_GT(inputs, 40);
}
