// Stores the arrays of the page of `blocks view` one after the other. They are encoded
// as differences, so that slow changes need little space, then deflated and written as
// text. unpack.js reads them back.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "post/page/view_numbers.hpp"

namespace blocks::post {

using Bytes = std::vector<unsigned char>;

struct PackedText {
  std::size_t bytes;  ///< of the zlib stream
  std::string
      text;  ///< 13 bits of the stream for each two letters of 91, the lower one first
};

class ViewStore {
 public:
  /// Adds values as they are in memory. type: f64, f32, u32, u16 or u8.
  template <class T>
  void add(const std::string& name, const char* type, const std::vector<T>& values) {
    note(name, type, values.size(), 0);
    const auto* from = reinterpret_cast<const unsigned char*>(values.data());
    bytes_.insert(bytes_.end(), from, from + values.size() * sizeof(T));
  }

  /// Adds frames of `rows` bytes each, as differences from the previous frame.
  void add_frames(const std::string& name, const Bytes& values, std::size_t rows);

  /// Adds numbers of six digits: the powers of ten as differences from the previous
  /// frame, then the digits as differences from a guess. `formula` is the name of the
  /// guess on the page; if it is empty, the better guess in time is used.
  void add_digits(const std::string& name, const DigitColumn& column,
                  const std::string& formula = {}, const Guess& guess = {});

  /// Adds frames of `rows` integers each, as differences from the previous frame.
  void add_whole(const std::string& name, const std::vector<int>& values,
                 std::size_t rows);

  /// Describes each array: name, type, number of values, rows of a frame, guess.
  const nlohmann::ordered_json& notes() const { return notes_; }

  /// Returns all arrays, packed.
  PackedText packed() const;

 private:
  void note(const std::string& name, const char* type, std::size_t count,
            std::size_t rows);
  void add_planes(const std::vector<std::uint32_t>& values, int planes);

  Bytes bytes_;
  nlohmann::ordered_json notes_ = nlohmann::ordered_json::array();
};

}  // namespace blocks::post
