// A ring of positions, as GeoJSON and WKT give it, becomes an outline: the closing
// point is dropped, numbers stay as written. Private to src/exchange.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// A number of the file and where it stands (offset in the text).
struct WrittenNumber {
  std::string_view text;
  std::size_t at = 0;
};
using Position = std::array<WrittenNumber, 2>;

/// Collects outlines and messages of one text.
class RingReader {
 public:
  /// Adds the outline of a closed ring; at: where its polygon begins. A ring that is
  /// not closed, too short, or has a number beyond the range of doubles is an error.
  void add(const std::vector<Position>& ring, long material, bool fixed,
           std::size_t at);

  void error(std::size_t at, std::string text, std::string hint = {},
             std::size_t length = 1);
  void warning(std::size_t at, std::string text, std::string hint = {});
  /// A polygon with `holes` inner rings: an error that says what to do.
  void refuse_holes(std::size_t holes, std::size_t at);
  /// Positions with more than two numbers; told once at the end.
  void saw_height(std::size_t at);

  /// found: "GeoJSON", to which the number of polygons is added.
  OutlineFile finish(const std::string& found);

 private:
  OutlineFile file_;
  std::size_t heights_ = 0, first_height_ = 0;
};

}  // namespace blocks::exchange
