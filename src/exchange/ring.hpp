// Converts a ring of positions, as in GeoJSON and WKT, to an outline. The closing point
// is dropped, and numbers stay as written. Private to src/exchange.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// A number of the file as written, and its offset in the text.
struct WrittenNumber {
  std::string_view text;
  std::size_t at = 0;
};
using Position = std::array<WrittenNumber, 2>;

/// What a file says about a polygon besides its ring.
struct RingData {
  long material = 0;
  bool fixed = false;
  /// Joint ids of the sides of the ring, in its order; empty: none.
  std::vector<int> joints = {};
  std::string layer = {};
};

/// Collects the outlines and messages of one text.
class RingReader {
 public:
  /// Adds the outline of a closed ring. at: offset of its polygon. It is an error if
  /// the ring is not closed, is too short, or contains a number beyond the range of
  /// doubles. The joint ids must be as many as the sides.
  void add(const std::vector<Position>& ring, RingData data, std::size_t at);

  /// Returns a joint id: a whole number from 0. Reports an error, and returns nothing,
  /// for other numbers. hint: what to do.
  std::optional<int> joint(const WrittenNumber& number, const std::string& hint);

  void add(Message message) { file_.messages.push_back(std::move(message)); }
  void error(std::size_t at, std::string text, std::string hint = {},
             std::size_t length = 1);
  void warning(std::size_t at, std::string text, std::string hint = {});
  /// Reports a polygon with `holes` inner rings as an error that says what to do.
  void refuse_holes(std::size_t holes, std::size_t at);
  /// Registers a position with more than two numbers; finish() reports all of them
  /// once.
  void saw_height(std::size_t at);

  /// Whether all corners so far are in the range of longitude and latitude.
  bool could_be_degrees() const;

  /// Returns the result. found: "GeoJSON"; the number of polygons is appended.
  OutlineFile finish(const std::string& found);

 private:
  OutlineFile file_;
  std::size_t heights_ = 0, first_height_ = 0;
};

}  // namespace blocks::exchange
