// The groups of a DXF drawing: a code and a value, each on a line of its own. Finds the
// entities and checks what the library that reads them takes on trust. Private to
// src/exchange.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/messages.hpp"

namespace blocks::exchange {

/// An entity of the section ENTITIES.
struct DxfEntity {
  std::string_view kind;     ///< "LINE"; of a POLYLINE with its vertices: "POLYLINE"
  std::size_t at = 0;        ///< offset of the kind in the text
  std::string_view groups;   ///< from its first group to the kind of the next entity
  bool is_on_paper = false;  ///< in paper space, as a title block is
};

/// The content of a drawing that its lines need.
struct DxfGroups {
  std::vector<DxfEntity> entities;  ///< in the order of the file
  int unit = 0;                     ///< $INSUNITS of the header; 0: not given
  std::vector<Message> messages;
};

/// Tests whether the text begins as an ASCII drawing does.
bool looks_like_dxf(std::string_view text);

/// Finds the entities. Errors, each with its place: lines that do not come in pairs, a
/// code that is not a whole number, lines of more than 1,000 characters, coordinates of
/// lines and curves that are no finite numbers, numbers of vertices, knots or control
/// points that differ from those that follow, more than 10 million entities, a binary
/// drawing, no section ENTITIES, no EOF at the end. After an error entities may be missing.
DxfGroups find_dxf_entities(std::string_view text);

}  // namespace blocks::exchange
