#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "exchange/block_record.hpp"

namespace blocks::exchange {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? shortest(value) : "null";
}

std::string text_of(const std::vector<RingPosition>& ring) {
  std::string text;
  for (const auto& [corner, joint] : ring)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", shortest(corner.x()),
                        shortest(corner.y()));
  return text;
}

/// Returns the property with the ids of all sides, in the order of the ring.
std::string joints_of(const std::vector<RingPosition>& ring) {
  std::string text;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", ring[i].joint);
  return ", \"joints\": [" + text + "]";
}

std::string name_of(const BlockRecord& block) {
  if (block.material_name.empty())
    return "";
  using Json = nlohmann::json;
  return ", \"material_name\": " +
         Json(block.material_name).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string write_geojson(const std::vector<BlockRecord>& blocks,
                          std::optional<double> time) {
  std::string text = "{\"type\": \"FeatureCollection\",\n";
  if (time)
    text += fmt::format("\"time\": {},\n", number(*time));
  text += "\"features\": [\n";
  const bool with_joints = has_joints(blocks);
  for (const BlockRecord& block : blocks) {
    const std::vector<RingPosition> ring = closed_ring(block);
    text += fmt::format("{{\"type\": \"Feature\", \"properties\": {{\"number\": {}, "
                        "\"material\": {}{}, \"fixed\": {}, \"area\": {}",
                        block.number, block.material, name_of(block), block.fixed,
                        number(block.area));
    if (with_joints)
      text += joints_of(ring);
    for (const auto& [name, value] : block.results)
      text += fmt::format(", \"{}\": {}", name, number(value));
    text += fmt::format("}}, \"geometry\": {{\"type\": \"Polygon\", \"coordinates\": "
                        "[[{}]]}}}}{}\n",
                        text_of(ring), &block == &blocks.back() ? "" : ",");
  }
  return text + "]}\n";
}

}  // namespace blocks::exchange
