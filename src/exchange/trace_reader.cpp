#include "exchange/trace_reader.hpp"

#include "exchange/foreign_form.hpp"
#include "exchange/forms.hpp"
#include "exchange/shape_collector.hpp"

namespace blocks::exchange {
namespace {

/// Fills the collector and returns the name of the form.
std::string collect(std::string_view text, ShapeCollector& shapes) {
  const std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const auto form = recognise(text);
  if (const auto foreign = form ? std::nullopt : foreign_form(text)) {
    shapes.error(nowhere, "this is " + foreign->name, foreign->hint);
    return "file";
  }
  if (!form)
    collect_csv(text, begin, shapes);
  else if (*form == Form::geojson)
    collect_geojson(text, shapes);
  else if (*form == Form::wkt)
    collect_wkt(text, begin, shapes);
  else
    collect_dxf(text, shapes);
  return form ? name_of(*form) : "CSV";
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
