#include "draw/png_resolution.hpp"

#include <cmath>
#include <cstdint>

namespace blocks::draw {
namespace {

/// Returns the checksum of the PNG standard (ISO 3309).
std::uint32_t checksum(const std::string& bytes) {
  std::uint32_t sum = 0xffffffffU;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      sum = (sum & 1U) != 0 ? (sum >> 1U) ^ 0xedb88320U : sum >> 1U;
  }
  return ~sum;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes += static_cast<char>((number >> shift) & 255U);
  return bytes;
}

}  // namespace

std::string with_resolution(std::string image, double resolution) {
  constexpr std::size_t after_header = 8 + 25;  // signature and IHDR
  const auto per_metre = static_cast<std::uint32_t>(std::lround(resolution / 0.0254));
  const std::string chunk =
      "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';  // unit: metre
  image.insert(after_header, big_endian(9) + chunk + big_endian(checksum(chunk)));
  return image;
}

}  // namespace blocks::draw
