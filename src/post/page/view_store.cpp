#include "post/page/view_store.hpp"

#include <zlib.h>

#include <stdexcept>

namespace blocks::post {
namespace {

/// The characters from "!" on without "&", "<" and ">", which HTML would need to
/// escape.
std::string letters(const Bytes& in) {
  std::string alphabet;
  for (char c = '!'; c <= '~'; ++c)
    if (c != '&' && c != '<' && c != '>')
      alphabet += c;
  std::string out;
  out.reserve(in.size() * 16 / 13 + 4);
  std::uint32_t held = 0;
  int bits = 0;
  const auto put = [&] {
    const std::uint32_t pair = held & 8191U;
    out += alphabet[pair % 91];
    out += alphabet[pair / 91];
    held >>= 13;
    bits -= 13;
  };
  for (const unsigned char byte : in) {
    held |= static_cast<std::uint32_t>(byte) << bits;
    if ((bits += 8) >= 13)
      put();
  }
  if (bits > 0)
    put();
  return out;
}

}  // namespace

void ViewStore::note(const std::string& name, const char* type, std::size_t count,
                     std::size_t rows) {
  notes_.push_back({{"name", name}, {"type", type}, {"count", count}, {"rows", rows}});
}

/// Stores the lowest bytes of all values, then the next bytes, and so on.
void ViewStore::add_planes(const std::vector<std::uint32_t>& values, int planes) {
  for (int k = 0; k < planes; ++k)
    for (const std::uint32_t value : values)
      bytes_.push_back(static_cast<unsigned char>(value >> (8 * k)));
}

void ViewStore::add_frames(const std::string& name, const Bytes& values,
                           std::size_t rows) {
  note(name, "frames", values.size(), rows);
  for (std::size_t i = 0; i < values.size(); ++i)
    bytes_.push_back(
        static_cast<unsigned char>(values[i] ^ (i < rows ? 0 : values[i - rows])));
}

void ViewStore::add_digits(const std::string& name, const DigitColumn& column,
                           const std::string& formula, const Guess& guess) {
  const auto& exact = column.exact;
  const std::size_t rows = column.rows;
  note(name, "digits", exact.size(), rows);
  for (std::size_t i = 0; i < exact.size(); ++i)
    bytes_.push_back(static_cast<unsigned char>(
        exact[i].power - (i < rows ? 0 : exact[i - rows].power)));
  if (formula.empty()) {
    const TimeGuess in_time = better_guess(column);
    notes_.back()["guess"] = in_time.linear ? "linear" : "before";
    add_planes(differences(column, in_time.of(column)), 3);
  } else {
    notes_.back()["guess"] = formula;
    add_planes(differences(column, guess), 3);
  }
}

void ViewStore::add_whole(const std::string& name, const std::vector<int>& values,
                          std::size_t rows) {
  note(name, "whole", values.size(), rows);
  std::vector<std::uint32_t> changes(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    changes[i] = folded(std::int64_t{values[i]} - (i < rows ? 0 : values[i - rows]));
  add_planes(changes, 4);
}

PackedText ViewStore::packed() const {
  uLongf size = compressBound(bytes_.size());
  Bytes deflated(size);
  if (compress2(deflated.data(), &size, bytes_.data(), bytes_.size(), 6) != Z_OK)
    throw std::runtime_error("the page's data cannot be compressed");
  deflated.resize(size);
  return {deflated.size(), letters(deflated)};
}

}  // namespace blocks::post
