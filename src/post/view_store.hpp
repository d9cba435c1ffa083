// The arrays that the page of `blocks view` carries: one behind the other, each told so
// that what hardly changes takes hardly any room, deflated, as text. page.js reads them
// back.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "post/view_numbers.hpp"

namespace blocks::post {

using Bytes = std::vector<unsigned char>;

struct PackedText {
  std::size_t bytes;  ///< of zlib's stream
  std::string text;   ///< 13 bits of it in two letters of 91, the lower first
};

class ViewStore {
 public:
  /// As they lie in memory. type: f64, f32, u16 or u8.
  template <class T>
  void add(const std::string& name, const char* type, const std::vector<T>& values) {
    note(name, type, values.size(), 0);
    const auto* from = reinterpret_cast<const unsigned char*>(values.data());
    bytes_.insert(bytes_.end(), from, from + values.size() * sizeof(T));
  }

  /// Frames of `rows` bytes each, against the frame before.
  void add_frames(const std::string& name, const Bytes& values, std::size_t rows);

  /// Numbers of six digits: powers of ten against the frame before, then what the
  /// digits differ from a guess. formula: the page's name for the guess; of none, the
  /// better one in time.
  void add_digits(const std::string& name, const DigitColumn& column,
                  const std::string& formula = {}, const Guess& guess = {});

  /// Frames of `rows` whole numbers each, against the frame before.
  void add_whole(const std::string& name, const std::vector<int>& values,
                 std::size_t rows);

  /// Where each array stands: name, type, number of values, rows of a frame, guess.
  const nlohmann::ordered_json& notes() const { return notes_; }

  /// All of it.
  PackedText packed() const;

 private:
  void note(const std::string& name, const char* type, std::size_t count,
            std::size_t rows);
  void add_planes(const std::vector<std::uint32_t>& values, int planes);

  Bytes bytes_;
  nlohmann::ordered_json notes_ = nlohmann::ordered_json::array();
};

}  // namespace blocks::post
