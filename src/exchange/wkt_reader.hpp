// Reads blocks from well-known text (OGC Simple Features): a sequence of POLYGON,
// MULTIPOLYGON and GEOMETRYCOLLECTION.
#pragma once

#include <string_view>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Reads the text. Geometries are on separate lines or separated by semicolons.
/// Outlines keep the order, orientation and first corner of the file; the closing
/// position is dropped. EMPTY and "SRID=n;" are skipped with a warning. Holes and other
/// geometries are errors. A syntax error ends the reading.
OutlineFile read_wkt(std::string_view text);

/// Tells whether the text begins with a keyword of well-known text, in any case.
bool looks_like_wkt(std::string_view text);

}  // namespace blocks::exchange
