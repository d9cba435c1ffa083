// Fortran unformatted sequential files: each record is between two 4-byte markers that
// hold its length (READ9 forms (c) and (d), docs/mesh-formats.md).
#include <fmt/format.h>

#include <bit>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {
namespace {

std::uint64_t unsigned_of(std::string_view bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char byte = big_endian ? bytes[i] : bytes[bytes.size() - 1 - i];
    value = value << 8 | static_cast<unsigned char>(byte);
  }
  return value;
}

// Tests for the length of a GENESIS title, or of seven integers of 4 or 8 bytes.
bool opens_a_mesh(std::uint64_t length) {
  return length == 80 || length == 28 || length == 56;
}

}  // namespace

bool Records::recognise(std::string_view data) {
  return data.size() > 4 && (opens_a_mesh(unsigned_of(data.substr(0, 4), false)) ||
                             opens_a_mesh(unsigned_of(data.substr(0, 4), true)));
}

Records::Records(std::string_view file, std::string_view data)
    : file_(file), data_(data) {
  big_endian_ = !opens_a_mesh(unsigned_of(data.substr(0, 4), false));
  for (std::size_t at = 0; at < data_.size();) {
    const Place here = place(records_.size());
    if (data_.size() - at < 4)
      fail(here, "the file ends within a record marker");
    const std::uint64_t length = bits(data_.substr(at, 4));
    if (length > INT32_MAX)
      fail(here, "record marker is negative: a record of 2 GB or more, or no Fortran "
                 "record at all");
    if (data_.size() - at < 8 + length)
      fail(here, fmt::format("the file ends within the record: {} announced, {} left",
                             counted(length, "byte"), data_.size() - at - 4));
    const std::uint64_t closing = bits(data_.substr(at + 4 + length, 4));
    if (closing != length)
      fail(here, fmt::format("opening marker {} and closing marker {} differ: not a "
                             "Fortran file with 4-byte markers, or damaged",
                             length, closing));
    records_.push_back(data_.substr(at + 4, length));
    at += 8 + length;
  }
}

std::uint64_t Records::bits(std::string_view bytes) const {
  return unsigned_of(bytes, big_endian_);
}

std::size_t Records::length(std::size_t i, const std::string& what) const {
  if (i >= records_.size())
    fail(place(i), fmt::format("the file ends before the {}", what));
  return records_[i].size();
}

long Records::integer(std::size_t i, std::size_t offset, std::size_t width) const {
  const std::uint64_t value = bits(records_.at(i).substr(offset, width));
  return width == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value))
                    : static_cast<std::int64_t>(value);
}

double Records::real(std::size_t i, std::size_t offset, std::size_t width) const {
  const std::uint64_t value = bits(records_.at(i).substr(offset, width));
  return width == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(value))
                    : std::bit_cast<double>(value);
}

std::string describe(const Records& records, std::size_t integer_width,
                     std::size_t real_width) {
  return fmt::format("{}-endian, {}-byte integers, {}-byte reals",
                     records.big_endian() ? "big" : "little", integer_width,
                     real_width);
}

}  // namespace blocks::deck::mesh
