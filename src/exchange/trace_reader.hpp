// Reads the traces of a TRACES card and the points of a VORONOI card from GeoJSON
// (RFC 7946), well-known text, CSV or a DXF drawing. The form is recognised by the
// content.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/messages.hpp"
#include "geometry/decimal.hpp"

namespace blocks::exchange {

/// A polyline of a trace file.
struct Trace {
  /// [L] exactly as written; at least two, and each differs from the one before.
  std::vector<geometry::DecimalPoint> points;
  std::optional<int> joint;  ///< joint id >= 0, if the file gives one
  int layer = -1;            ///< index into the layers of the file; -1: none
  std::size_t line = 1;      ///< line of the file where the polyline begins, from 1
};

/// The content of a trace file. If the messages contain errors, traces may be missing.
struct TraceFile {
  std::string form;   ///< "GeoJSON", "WKT", "CSV", "DXF" or "file", for exchange::format
  std::string found;  ///< summary: "GeoJSON, 12 polylines, 40 segments"
  std::vector<Trace> traces;
  std::vector<std::string> layers;  ///< that have traces, by their first trace
  std::string unit;                 ///< of length, if a drawing states one: "mm"
  std::vector<Message> messages;
};

/// The content of a file of points. If the messages contain errors, points may be
/// missing.
struct PointFile {
  std::string form;   ///< "GeoJSON", "WKT", "CSV" or "file", for exchange::format
  std::string found;  ///< summary: "WKT, 12 points"
  std::vector<geometry::DecimalPoint> points;  ///< [L] exactly as written
  std::vector<Message> messages;
};

/// Reads polylines in the order of the file.
/// - GeoJSON: LineString, MultiLineString and collections of them. The property "joint"
///   of a feature gives the joint id, "layer" or "Layer" its layer.
/// - WKT: LINESTRING, MULTILINESTRING and GEOMETRYCOLLECTION, on separate lines or
///   separated by semicolons.
/// - CSV: x1, y1, x2, y2 per line, separated by commas, semicolons or blanks. A first
///   line may name the columns, in any order and with a column `joint`. A # begins a
///   comment.
/// - DXF: lines, polylines and curves (dxf_reader.hpp). A number in the name
///   of a layer ("3_bedding", "joint_3") gives the joint id.
/// Errors: files of other programs (foreign_form.hpp), other geometries, a polyline
/// with fewer than two different points, numbers that are not finite, a joint id that
/// is not a whole number >= 0, no polylines at all. Warnings: repeated points and
/// further coordinates, which are dropped; GeoJSON with coordinates that are degrees
/// or, without a member "crs", look like degrees. All errors are reported in one pass;
/// only a syntax error of GeoJSON or WKT ends it.
TraceFile read_traces(std::string_view text);

/// Reads points in the order of the file: GeoJSON Point and MultiPoint, WKT POINT and
/// MULTIPOINT, collections of them, and CSV with x, y per line. Errors as in
/// read_traces. Points that occur twice are kept.
PointFile read_points(std::string_view text);

}  // namespace blocks::exchange
