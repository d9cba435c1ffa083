#include "draw/png_resolution.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

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

void set_png_resolution(const std::string& path, double resolution) {
  constexpr std::size_t after_header = 8 + 25;  // signature and IHDR
  std::string image;
  {
    std::ifstream in(path, std::ios::binary);
    image.assign(std::istreambuf_iterator<char>(in), {});
  }
  if (image.size() < after_header)
    throw std::runtime_error("cannot read " + path + " again");
  const auto per_metre = static_cast<std::uint32_t>(std::lround(resolution / 0.0254));
  const std::string chunk =
      "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';  // unit: metre
  image.insert(after_header, big_endian(9) + chunk + big_endian(checksum(chunk)));
  std::ofstream out(path, std::ios::binary);
  out << image;
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + path);
}

}  // namespace blocks::draw
