#include "exchange/geojson_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "exchange/geographic_crs.hpp"
#include "exchange/geojson_nodes.hpp"
#include "exchange/ring.hpp"

namespace blocks::exchange {
namespace {

constexpr const char* hint_of_joints =
    "give one id for each side, in the order of the positions, 0 for none";

/// The properties of a feature.
struct Properties {
  RingData data;
  const Json* joints = nullptr;  ///< the property, an array; null: absent
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  OutlineFile read() {
    try {
      const Json root = parse_json(text_);
      if (!nodes_.expect(root, Json::Kind::object, "the file"))
        return rings_.finish("GeoJSON");
      object(root, {});
      if (const auto name = geographic_crs(root); name && rings_.could_be_degrees())
        rings_.warning(root.find("crs")->at, degrees_as_lengths(*name),
                       hint_of_degrees);
    } catch (const JsonFault& fault) {
      rings_.error(std::min(fault.at, text_.size()), fault.what());
    }
    OutlineFile file = rings_.finish("GeoJSON");
    file.material_names = std::move(names_);
    return file;
  }

 private:
  std::string_view text_;
  RingReader rings_;
  GeoJsonNodes<RingReader> nodes_{rings_};
  const Json* used_joints_ = nullptr;  ///< property that the last polygon used
  std::map<long, std::string> names_;

  void object(const Json& node, const Properties& properties);
  void feature(const Json& node);
  Properties read_properties(const Json& node);
  void read_name(const Json& node, long material);
  bool read_joints(const Json& node, std::size_t sides, std::vector<int>& joints);
  void polygon(const Json& rings, const Properties& properties);
  bool ring(const Json& node, std::vector<Position>& positions);
};

void Reader::object(const Json& node, const Properties& properties) {
  const Json* type = nodes_.member(node, "type", Json::Kind::string);
  if (!type)
    return;
  const auto each = [&](const std::string& key, auto&& action) {
    if (const Json* list = nodes_.member(node, key, Json::Kind::array))
      for (const Json& item : list->items)
        action(item);
  };
  const auto as_object = [&](const Json& item, const Properties& with) {
    if (nodes_.expect(item, Json::Kind::object, type->text))
      object(item, with);
  };
  if (type->text == "FeatureCollection")
    each("features", [&](const Json& item) { as_object(item, {}); });
  else if (type->text == "Feature")
    feature(node);
  else if (type->text == "GeometryCollection")
    each("geometries", [&](const Json& item) { as_object(item, properties); });
  else if (type->text == "MultiPolygon")
    each("coordinates", [&](const Json& item) { polygon(item, properties); });
  else if (type->text != "Polygon")
    rings_.error(node.at, fmt::format("{} cannot be a block", type->text.substr(0, 40)),
                 "use Polygon, MultiPolygon or collections of them");
  else if (const Json* rings = nodes_.member(node, "coordinates", Json::Kind::array))
    polygon(*rings, properties);
}

void Reader::feature(const Json& node) {
  Properties properties;
  if (const Json* given = node.find("properties");
      given && given->kind != Json::Kind::null &&
      nodes_.expect(*given, Json::Kind::object, "\"properties\""))
    properties = read_properties(*given);
  const Json* geometry = node.find("geometry");
  if (!geometry || geometry->kind == Json::Kind::null)
    rings_.warning(node.at, "a feature without geometry is skipped");
  else if (nodes_.expect(*geometry, Json::Kind::object, "\"geometry\""))
    object(*geometry, properties);
}

Properties Reader::read_properties(const Json& node) {
  Properties properties;
  if (const Json* material = node.find("material");
      material && material->kind != Json::Kind::null) {
    double value = 0;
    const std::string_view text = material->number;
    std::from_chars(text.data(), text.data() + text.size(), value);
    if (value >= 1 && value <= std::numeric_limits<int>::max() &&
        value == std::floor(value))
      properties.data.material = static_cast<long>(value);
    else
      rings_.error(material->at, "\"material\" should be a whole number from 1",
                   "remove the property and give --material N instead");
  }
  read_name(node, properties.data.material);
  properties.data.layer = layer_of(node);
  if (const Json* fixed = node.find("fixed");
      fixed && fixed->kind != Json::Kind::null) {
    if (fixed->kind == Json::Kind::boolean)
      properties.data.fixed = fixed->text == "true";
    else if (fixed->number == "0" || fixed->number == "1")
      properties.data.fixed = fixed->number == "1";
    else
      rings_.error(fixed->at, "\"fixed\" should be true or false");
  }
  if (const Json* joints = node.find("joints");
      joints && joints->kind != Json::Kind::null) {
    if (joints->kind == Json::Kind::array)
      properties.joints = joints;
    else
      rings_.error(joints->at,
                   "\"joints\": expected an array, found " + name_of(joints->kind),
                   hint_of_joints);
  }
  return properties;
}

/// Reads the name of a material. A material has one name, and the first one stays.
void Reader::read_name(const Json& node, long material) {
  const Json* name = node.find("material_name");
  if (!name || name->kind == Json::Kind::null)
    return;
  if (!nodes_.expect(*name, Json::Kind::string, "\"material_name\"") ||
      name->text.empty() || material == 0)
    return;
  const auto [first, is_new] = names_.emplace(material, name->text);
  if (!is_new && first->second != name->text)
    rings_.warning(name->at,
                   fmt::format("material {} has another name, {}, which is kept",
                               material, first->second));
}

/// Reads the ids of the sides of one ring. The array belongs to a single polygon.
bool Reader::read_joints(const Json& node, std::size_t sides,
                         std::vector<int>& joints) {
  const std::string hint = hint_of_joints;
  if (used_joints_ == &node) {
    rings_.error(node.at, "\"joints\" belongs to a feature with several polygons",
                 "write one feature for each polygon");
    return false;
  }
  used_joints_ = &node;
  if (node.items.size() != sides) {
    rings_.error(node.at,
                 fmt::format("\"joints\" has {} id{}, the polygon {} sides",
                             node.items.size(), node.items.size() == 1 ? "" : "s",
                             sides),
                 hint);
    return false;
  }
  for (const Json& item : node.items) {
    if (item.kind != Json::Kind::number) {
      rings_.error(item.at, "joint id: expected a number, found " + name_of(item.kind),
                   hint);
      return false;
    }
    const auto id = rings_.joint({item.number, item.at}, hint);
    if (!id)
      return false;
    joints.push_back(*id);
  }
  return true;
}

void Reader::polygon(const Json& rings, const Properties& properties) {
  if (!nodes_.expect(rings, Json::Kind::array, "polygon"))
    return;
  const auto is_position = [](const Json& ring) {
    return !ring.items.empty() && ring.items[0].kind == Json::Kind::number;
  };
  if (rings.items.empty())
    rings_.warning(rings.at, "an empty polygon is skipped");
  else if (is_position(rings.items[0]))
    rings_.error(rings.at, "ring: expected an array of positions, found a position",
                 "a polygon is an array of rings, a ring an array of positions");
  else if (rings.items.size() > 1)
    rings_.refuse_holes(rings.items.size() - 1, rings.at);
  else if (std::vector<Position> positions; ring(rings.items[0], positions)) {
    RingData data = properties.data;
    if (!properties.joints || positions.size() < 4 ||
        read_joints(*properties.joints, positions.size() - 1, data.joints))
      rings_.add(positions, std::move(data), rings.at);
  }
}

bool Reader::ring(const Json& node, std::vector<Position>& positions) {
  if (!nodes_.expect(node, Json::Kind::array, "ring"))
    return false;
  for (const Json& item : node.items) {
    const auto position = nodes_.position(item);
    if (!position)
      return false;
    positions.push_back(*position);
  }
  return true;
}

}  // namespace

OutlineFile read_geojson(std::string_view text) { return Reader(text).read(); }

}  // namespace blocks::exchange
