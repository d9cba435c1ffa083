// What the readers of foreign files hand over: outlines with their numbers as written.
// Plain structs; nothing here knows the deck.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exchange/messages.hpp"
#include "geometry/vec2.hpp"

namespace blocks::exchange {

/// x and y of a corner digit for digit as the file has them; READ9's text form reads
/// the same doubles from them.
using WrittenCorner = std::array<std::string, 2>;

/// One block as another program wrote it.
struct Outline {
  geometry::Polygon corners;  ///< [L] nearest doubles, in the file's order, not closed
  std::vector<WrittenCorner> written;  ///< same corners; may be empty
  long material = 0;                   ///< 0: the file does not say
  bool fixed = false;
  std::size_t at = nowhere;  ///< offset of the polygon in the text
};

/// A file read to its end; with errors among the messages the outlines are not all
/// there.
struct OutlineFile {
  std::string found;  ///< in words: "GeoJSON, 12 polygons"
  std::vector<Outline> outlines;
  std::vector<Message> messages;
};

/// The outline in the other sense, corner 1 kept first, numbers as written
/// too.
void reverse(Outline& outline);

}  // namespace blocks::exchange
