// The forms of files with blocks, outlines and joints, recognised by their content.
#pragma once

#include <optional>
#include <string_view>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

enum class Form { geojson, wkt, dxf };

/// Returns "GeoJSON", "WKT" or "DXF".
const char* name_of(Form form);

/// Returns the form by the first characters that are not blank; nothing for another
/// form, such as a table of numbers or a mesh.
std::optional<Form> recognise(std::string_view text);

/// Reads polygons in this form.
OutlineFile read_outlines(Form form, std::string_view text);

}  // namespace blocks::exchange
