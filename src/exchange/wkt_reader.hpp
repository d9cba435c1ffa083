// Blocks from well-known text (OGC Simple Features): POLYGON, MULTIPOLYGON and
// GEOMETRYCOLLECTION, one after the other.
#pragma once

#include <string_view>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Reads the text; geometries stand on lines of their own or are parted by semicolons.
/// Outlines keep the file's order, sense and first corner; the closing position is
/// dropped. EMPTY and "SRID=n;" are passed over with a warning. Holes and other
/// geometries are errors; a fault of the syntax ends the reading.
OutlineFile read_wkt(std::string_view text);

/// Whether the text begins with a word of well-known text, in any case.
bool looks_like_wkt(std::string_view text);

}  // namespace blocks::exchange
