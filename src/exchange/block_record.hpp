// A block for export to other programs. Plain structs, independent of the model and the
// results.
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
  std::string material_name;  ///< may be empty
  bool fixed = false;
  double area = 0.0;                                    ///< [L^2]
  geometry::Polygon outline;                            ///< [L] clockwise, not closed
  std::vector<std::pair<std::string, double>> results;  ///< name and value
};

/// Returns the shortest decimal that reads back as the same double.
std::string shortest(double value);

/// Returns a GeoJSON FeatureCollection with one feature per line. The name of a
/// material is the property "material_name". Rings are
/// anticlockwise (RFC 7946) and begin and end with corner 1. time: written as a member
/// of the collection. Values that are not finite become null.
std::string write_geojson(const std::vector<BlockRecord>& blocks,
                          std::optional<double> time = {});

/// Returns WKT with one POLYGON per line; rings are as in GeoJSON. WKT cannot hold
/// materials.
std::string write_wkt(const std::vector<BlockRecord>& blocks);

/// Returns Gmsh 2.2 ASCII. Corners at the same point share a node; elements are
/// anticlockwise from corner 1; the material is the physical group, with its name if it
/// has one. Every block must
/// have 3 or 4 corners. Throws std::invalid_argument that names the first block with
/// more.
std::string write_gmsh(const std::vector<BlockRecord>& blocks);

}  // namespace blocks::exchange
