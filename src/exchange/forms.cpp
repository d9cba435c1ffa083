#include "exchange/forms.hpp"

#include "exchange/dxf_groups.hpp"
#include "exchange/dxf_reader.hpp"
#include "exchange/geojson_reader.hpp"
#include "exchange/wkt_reader.hpp"

namespace blocks::exchange {

const char* name_of(Form form) {
  return form == Form::geojson ? "GeoJSON" : form == Form::wkt ? "WKT" : "DXF";
}

std::optional<Form> recognise(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first != text.npos && (text[first] == '{' || text[first] == '['))
    return Form::geojson;
  if (looks_like_dxf(text))
    return Form::dxf;
  return looks_like_wkt(text) ? std::optional(Form::wkt) : std::nullopt;
}

OutlineFile read_outlines(Form form, std::string_view text) {
  return form == Form::geojson ? read_geojson(text)
         : form == Form::wkt   ? read_wkt(text)
                               : read_dxf(text);
}

}  // namespace blocks::exchange
