// Blocks from GeoJSON (RFC 7946): Polygon, MultiPolygon, GeometryCollection, Feature,
// FeatureCollection; properties "material" and "fixed".
#pragma once

#include <string_view>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Reads the text. Outlines keep the file's order, sense and first corner; the closing
/// position is dropped. Errors, all in one pass: holes, rings that are not closed,
/// other geometries, properties of the wrong kind. Coordinates are lengths: no map
/// projection is applied.
OutlineFile read_geojson(std::string_view text);

}  // namespace blocks::exchange
