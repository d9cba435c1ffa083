#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "exchange/block_record.hpp"

namespace blocks::exchange {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? shortest(value) : "null";
}

/// Returns corner 1, the other corners in reverse order, and corner 1 again.
std::string ring(const geometry::Polygon& outline) {
  std::string text;
  for (std::size_t i = 0; i <= outline.size(); ++i) {
    const geometry::Vec2& corner = outline[(outline.size() - i) % outline.size()];
    text += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", shortest(corner.x()),
                        shortest(corner.y()));
  }
  return text;
}

std::string name_of(const BlockRecord& block) {
  if (block.material_name.empty())
    return "";
  using Json = nlohmann::json;
  return ", \"material_name\": " +
         Json(block.material_name).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

// {fmt} and std::to_chars give the shortest digits. "-0" keeps its sign, because the
// readers here read the digits as written.
std::string shortest(double value) { return fmt::format("{}", value); }

std::string write_geojson(const std::vector<BlockRecord>& blocks,
                          std::optional<double> time) {
  std::string text = "{\"type\": \"FeatureCollection\",\n";
  if (time)
    text += fmt::format("\"time\": {},\n", number(*time));
  text += "\"features\": [\n";
  for (const BlockRecord& block : blocks) {
    text += fmt::format("{{\"type\": \"Feature\", \"properties\": {{\"number\": {}, "
                        "\"material\": {}{}, \"fixed\": {}, \"area\": {}",
                        block.number, block.material, name_of(block), block.fixed,
                        number(block.area));
    for (const auto& [name, value] : block.results)
      text += fmt::format(", \"{}\": {}", name, number(value));
    text += fmt::format("}}, \"geometry\": {{\"type\": \"Polygon\", \"coordinates\": "
                        "[[{}]]}}}}{}\n",
                        ring(block.outline), &block == &blocks.back() ? "" : ",");
  }
  return text + "]}\n";
}

}  // namespace blocks::exchange
