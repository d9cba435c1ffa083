// The result of the readers of foreign files: outlines with their numbers as written.
// Plain structs, independent of the deck.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "exchange/messages.hpp"
#include "geometry/vec2.hpp"

namespace blocks::exchange {

/// x and y of a corner exactly as written in the file. READ9's text form reads the same
/// doubles from them.
using WrittenCorner = std::array<std::string, 2>;

/// One block of a foreign file.
struct Outline {
  geometry::Polygon corners;  ///< [L] nearest doubles, in the file's order, not closed
  std::vector<WrittenCorner> written;  ///< the same corners as written; may be empty
  /// Joint id of the side that begins at each corner, >= 0; empty: 0 for all sides.
  std::vector<int> joints;
  long material = 0;  ///< 0 if the file has none
  bool fixed = false;
  std::string layer;  ///< of a drawing, or the property of a feature; may be empty
  std::size_t at = nowhere;  ///< offset of the polygon in the text
};

/// Lines of a drawing that are not closed, and so are no outlines.
struct OpenLines {
  std::size_t n = 0;
  std::size_t first = nowhere;  ///< offset of the first one in the text
};

/// The content of a file. If the messages contain errors, outlines may be missing.
struct OutlineFile {
  std::string found;  ///< summary: "GeoJSON, 12 polygons"
  std::vector<Outline> outlines;
  std::map<long, std::string> material_names;  ///< of the materials that have one
  std::string unit;  ///< of length, if a drawing states one: "mm"
  OpenLines open;
  std::vector<Message> messages;
};

/// Reverses the orientation of the outline, including the numbers as written; corner 1
/// stays first. Each side keeps its joint id, but then begins at its other end.
void reverse(Outline& outline);

}  // namespace blocks::exchange
