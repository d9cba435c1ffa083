// The kinds of entities of a DXF drawing. Private to src/exchange.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace blocks::exchange {

/// Whether the entity is a line or curve that is read.
inline bool is_dxf_line(std::string_view kind) {
  constexpr std::array kinds{"LINE",   "LWPOLYLINE", "POLYLINE", "ARC",
                             "CIRCLE", "ELLIPSE",    "SPLINE"};
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Whether the entity is a body or surface in space, which has no place in a plane.
inline bool is_dxf_solid(std::string_view kind) {
  constexpr std::array kinds{"3DFACE",
                             "3DSOLID",
                             "BODY",
                             "REGION",
                             "MESH",
                             "SURFACE",
                             "EXTRUDEDSURFACE",
                             "REVOLVEDSURFACE",
                             "LOFTEDSURFACE",
                             "SWEPTSURFACE",
                             "PLANESURFACE",
                             "NURBSURFACE"};
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace blocks::exchange
