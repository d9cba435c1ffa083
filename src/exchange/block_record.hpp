// A block as it goes out to other programs. Plain structs; nothing here knows the model
// or the results.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::exchange {

struct BlockRecord {
  int number = 0;  ///< from 1
  int material = 0;
  bool fixed = false;
  double area = 0.0;                                    ///< [L^2]
  geometry::Polygon outline;                            ///< [L] clockwise, not closed
  std::vector<std::pair<std::string, double>> results;  ///< name and value
};

/// The decimal with the fewest digits that reads back as the same double.
std::string shortest(double value);

/// GeoJSON FeatureCollection, a feature to the line; rings anticlockwise (RFC 7946),
/// beginning and ending with corner 1. time: a member of the collection. Values that
/// are not finite become null.
std::string write_geojson(const std::vector<BlockRecord>& blocks,
                          std::optional<double> time = {});

/// WKT, a POLYGON to the line, rings as in GeoJSON. Materials have no place in it.
std::string write_wkt(const std::vector<BlockRecord>& blocks);

/// Gmsh 2.2 ASCII: nodes shared where corners are the same point, elements
/// anticlockwise from corner 1, material = physical group. Every block must have 3 or 4
/// corners: throws std::invalid_argument naming the first that has more.
std::string write_gmsh(const std::vector<BlockRecord>& blocks);

}  // namespace blocks::exchange
