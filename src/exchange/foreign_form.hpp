// Recognises files of other programs, so that a reader can say what it was given and
// how to convert it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace blocks::exchange {

/// How to convert a map of another program.
inline constexpr const char* hint_of_ogr2ogr =
    "convert it: ogr2ogr -f GeoJSON -lco SIGNIFICANT_FIGURES=17 map.geojson FILE "
    "(docs/exchange.md)";

/// A form that no reader of this folder reads.
struct ForeignForm {
  std::string name;      ///< "a shapefile"
  std::string hint;      ///< how to make a file that can be read
  bool is_known = true;  ///< false: only known to be binary
};

/// Returns the form of a file that is neither GeoJSON, WKT nor text, recognised by its
/// first bytes: a shapefile, a GeoPackage, an archive, a document, a picture, XML or
/// text in UTF-16. Any other file with a zero byte among the first 512 is binary.
/// Returns nothing for other text.
std::optional<ForeignForm> foreign_form(std::string_view bytes);

}  // namespace blocks::exchange
