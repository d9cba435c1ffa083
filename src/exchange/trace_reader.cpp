#include "exchange/trace_reader.hpp"

#include "exchange/shape_collector.hpp"
#include "exchange/wkt_reader.hpp"

namespace blocks::exchange {
namespace {

/// Fills the collector and returns the name of the form.
std::string collect(std::string_view text, ShapeCollector& shapes) {
  const std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::size_t first = text.find_first_not_of(" \t\r\n", begin);
  if (first != text.npos && (text[first] == '{' || text[first] == '[')) {
    collect_geojson(text, shapes);
    return "GeoJSON";
  }
  if (looks_like_wkt(text.substr(begin))) {
    collect_wkt(text, begin, shapes);
    return "WKT";
  }
  collect_csv(text, begin, shapes);
  return "CSV";
}

}  // namespace

TraceFile read_traces(std::string_view text) {
  ShapeCollector shapes(text, Shapes::lines);
  const std::string form = collect(text, shapes);
  return shapes.finish_traces(form);
}

PointFile read_points(std::string_view text) {
  ShapeCollector shapes(text, Shapes::points);
  const std::string form = collect(text, shapes);
  return shapes.finish_points(form);
}

}  // namespace blocks::exchange
