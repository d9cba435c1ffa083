// Reads the lines of a DXF drawing with libdxflib.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/messages.hpp"
#include "exchange/outlines.hpp"
#include "geometry/vec2.hpp"

namespace blocks::exchange {

/// A line, polyline or curve of a drawing.
struct DxfLine {
  std::vector<geometry::Vec2> points;  ///< [L]; a closed line does not repeat the first
  bool is_closed = false;
  std::size_t layer = 0;  ///< index into the layers
  std::size_t at = 0;     ///< offset of the entity in the text
};

/// The lines of a drawing in the order of the file. If the messages contain errors,
/// lines may be missing.
struct DxfDrawing {
  std::vector<DxfLine> lines;
  std::vector<std::string> layers;  ///< that have lines, by their first line
  std::string unit;          ///< of length, by the header: "mm"; empty: none given
  std::size_t curves = 0;    ///< arcs, circles, ellipses, splines and arcs of polylines
  std::size_t chords = 0;    ///< into which they are divided
  double chord_error = 0.0;  ///< [L] no point of a curve is further from its chords
  std::vector<Message> messages;
};

/// Chords are at most this part of the size of their curve away from it, where the size
/// is the diagonal of the box around its control points or its circle.
inline constexpr double chord_part = 1e-3;

/// Reads LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE and SPLINE of model space.
/// Coordinates are the nearest doubles; heights are dropped with a warning. Errors:
/// those of find_dxf_entities, bodies and surfaces in space, planes of drawing other
/// than xy, splines that are not defined. Other entities, such as texts and block
/// references, are not read, which a warning says.
DxfDrawing read_drawing(std::string_view text);

/// Reads closed lines, and lines that end where they begin, as blocks. A layer with a
/// number in its name (parse_layer) gives that material and its name; the layer 0 gives
/// none; others get the numbers that are left, in order.
OutlineFile read_dxf(std::string_view text);

/// The number and the rest of a layer's name: "2 granite", "2_granite", "granite_2" and
/// "2" have number 2; other names have none.
struct LayerName {
  std::optional<int> number;
  std::string name;
};
LayerName parse_layer(const std::string& name);

/// "2 curves as 40 chords, off by 0.01 at most", or an empty text.
std::string describe_chords(const DxfDrawing& drawing);

}  // namespace blocks::exchange
