// Reads blocks from GeoJSON (RFC 7946): Polygon, MultiPolygon, GeometryCollection,
// Feature, FeatureCollection; properties "material" and "fixed".
#pragma once

#include <string_view>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Reads the text. Outlines keep the order, orientation and first corner of the file;
/// the closing position is dropped. All errors are reported in one pass: holes, rings
/// that are not closed, other geometries, properties of the wrong type. Coordinates are
/// lengths; no map projection is applied.
OutlineFile read_geojson(std::string_view text);

}  // namespace blocks::exchange
