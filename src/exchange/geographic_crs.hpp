// Tells whether coordinates are degrees of longitude and latitude. Private to
// src/exchange.
#pragma once

#include <optional>
#include <string>

#include "exchange/json_tree.hpp"

namespace blocks::exchange {

/// How to make lengths of degrees.
inline constexpr const char* hint_of_degrees =
    "project the map by ogr2ogr -t_srs (docs/exchange.md); if they are lengths, write "
    "\"crs\": null";

/// Whether the EPSG code is that of longitude and latitude: WGS 84 and the national
/// systems of the same kind that maps of rock use most.
bool is_geographic(long epsg);

/// Returns the name of the system of a GeoJSON file if its coordinates are degrees
/// according to its member "crs"; otherwise nothing.
std::optional<std::string> geographic_crs(const Json& root);

/// Returns the text of the warning that degrees are taken as lengths.
std::string degrees_as_lengths(const std::string& system);

}  // namespace blocks::exchange
