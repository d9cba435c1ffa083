#include "exchange/foreign_form.hpp"

#include <array>

namespace blocks::exchange {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  const char* name;
  const char* hint;
};

constexpr const char* by_unpacking =
    "unpack it; ogr2ogr converts a shapefile or KML to GeoJSON (docs/exchange.md)";
constexpr const char* by_digitising =
    "draw its lines in a mapping program and save them as GeoJSON";
constexpr const char* as_utf8 = "save it as UTF-8";

constexpr std::array signatures{
    Signature{"\0\0\x27\x0A"sv, "a shapefile", hint_of_ogr2ogr},
    Signature{"SQLite format 3\0"sv, "a GeoPackage or another SQLite database",
              hint_of_ogr2ogr},
    Signature{"fgb\x03"sv, "a FlatGeobuf file", hint_of_ogr2ogr},
    Signature{"PK\x03\x04"sv, "a zip archive", by_unpacking},
    Signature{"\x1F\x8B"sv, "a gzip archive", by_unpacking},
    Signature{"%PDF-"sv, "a PDF document", by_digitising},
    Signature{"\x89PNG"sv, "a picture", by_digitising},
    Signature{"\xFF\xD8\xFF"sv, "a picture", by_digitising},
    Signature{"II*\0"sv, "a picture", by_digitising},
    Signature{"MM\0*"sv, "a picture", by_digitising},
    Signature{"\xFF\xFE"sv, "text in UTF-16", as_utf8},
    Signature{"\xFE\xFF"sv, "text in UTF-16", as_utf8}};

}  // namespace

std::optional<ForeignForm> foreign_form(std::string_view bytes) {
  for (const Signature& one : signatures)
    if (bytes.starts_with(one.bytes))
      return ForeignForm{one.name, one.hint};
  const std::size_t begin = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n", begin);
  if (first != bytes.npos && bytes[first] == '<')
    return ForeignForm{"XML, such as KML or GML", hint_of_ogr2ogr};
  if (bytes.substr(0, 512).find('\0') != bytes.npos)
    return ForeignForm{
        "a binary file",
        "give GeoJSON, WKT or CSV; ogr2ogr converts most forms of maps to "
        "GeoJSON (docs/exchange.md)",
        false};
  return std::nullopt;
}

}  // namespace blocks::exchange
