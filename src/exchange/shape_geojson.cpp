#include <fmt/format.h>

#include <algorithm>

#include "exchange/foreign_form.hpp"
#include "exchange/geographic_crs.hpp"
#include "exchange/geojson_nodes.hpp"
#include "exchange/shape_collector.hpp"

namespace blocks::exchange {
namespace {

class GeoJsonShapes {
 public:
  explicit GeoJsonShapes(ShapeCollector& shapes) : shapes_(shapes) {}

  void read(const Json& root) {
    if (!nodes_.expect(root, Json::Kind::object, "the file"))
      return;
    object(root, {});
    using enum ShapeCollector::Degrees;
    const Json* crs = root.find("crs");
    if (const auto name = geographic_crs(root); name && shapes_.degrees() != impossible)
      shapes_.warning(crs->at, degrees_as_lengths(*name), hint_of_degrees);
    else if (!crs && shapes_.degrees() == likely)
      shapes_.warning(
          root.at,
          "the coordinates look like degrees of longitude and latitude, and "
          "are taken as lengths",
          hint_of_degrees);
  }

 private:
  ShapeCollector& shapes_;
  GeoJsonNodes<ShapeCollector> nodes_{shapes_};

  /// Returns the items of an array member, or reports an error and returns none.
  const std::vector<Json>& items(const Json& object, const std::string& key) {
    static const std::vector<Json> none;
    const Json* found = nodes_.member(object, key, Json::Kind::array);
    return found ? found->items : none;
  }

  /// What a feature says about its lines.
  struct Data {
    std::optional<int> joint;
    std::string layer;
  };

  void object(const Json& node, const Data& data);
  void feature(const Json& node);
  Data properties(const Json& node);
  void line(const Json& node, const Data& data);
  void point(const Json& node);
};

void GeoJsonShapes::object(const Json& node, const Data& data) {
  const Json* type = node.find("type");
  if (!type) {
    const bool is_esri = node.find("geometryType") != nullptr;
    shapes_.error(node.at, is_esri ? "this is JSON of Esri" : "\"type\" is missing",
                  is_esri ? hint_of_ogr2ogr : "");
    return;
  }
  if (!nodes_.expect(*type, Json::Kind::string, "\"type\""))
    return;
  const bool lines = shapes_.wanted() == Shapes::lines;
  const auto objects = [&](const char* key, const Data& with) {
    for (const Json& item : items(node, key))
      if (nodes_.expect(item, Json::Kind::object, type->text))
        object(item, with);
  };
  if (type->text == "FeatureCollection") {
    objects("features", {});
  } else if (type->text == "Feature") {
    feature(node);
  } else if (type->text == "GeometryCollection") {
    objects("geometries", data);
  } else if (lines && type->text == "MultiLineString") {
    for (const Json& item : items(node, "coordinates"))
      line(item, data);
  } else if (!lines && type->text == "MultiPoint") {
    for (const Json& item : items(node, "coordinates"))
      point(item);
  } else if (type->text != (lines ? "LineString" : "Point")) {
    shapes_.refuse(node.at, type->text.substr(0, 40));
  } else if (const Json* found = node.find("coordinates"); !found) {
    shapes_.error(node.at, "\"coordinates\" is missing");
  } else if (lines) {
    line(*found, data);
  } else {
    point(*found);
  }
}

GeoJsonShapes::Data GeoJsonShapes::properties(const Json& node) {
  Data data;
  const Json* given = node.find("properties");
  if (!given || given->kind == Json::Kind::null ||
      !nodes_.expect(*given, Json::Kind::object, "\"properties\"") ||
      shapes_.wanted() != Shapes::lines)
    return data;
  if (const Json* id = given->find("joint");
      id && id->kind != Json::Kind::null &&
      nodes_.expect(*id, Json::Kind::number, "\"joint\""))
    data.joint = shapes_.joint({id->number, id->at});
  data.layer = layer_of(*given);
  return data;
}

void GeoJsonShapes::feature(const Json& node) {
  const Data data = properties(node);
  const Json* geometry = node.find("geometry");
  if (!geometry || geometry->kind == Json::Kind::null)
    shapes_.warning(node.at, "a feature without geometry is skipped");
  else if (nodes_.expect(*geometry, Json::Kind::object, "\"geometry\""))
    object(*geometry, data);
}

void GeoJsonShapes::line(const Json& node, const Data& data) {
  if (!nodes_.expect(node, Json::Kind::array, "line"))
    return;
  if (node.items.empty()) {
    shapes_.warning(node.at, "an empty line is skipped");
    return;
  }
  std::vector<Position> positions;
  for (const Json& item : node.items) {
    const auto found = nodes_.position(item);
    if (!found)
      return;
    positions.push_back(*found);
  }
  shapes_.add_line(positions, data.joint, node.at, data.layer);
}

void GeoJsonShapes::point(const Json& node) {
  if (const auto found = nodes_.position(node))
    shapes_.add_point(*found);
}

}  // namespace

void collect_geojson(std::string_view text, ShapeCollector& shapes) {
  try {
    const Json root = parse_json(text);
    GeoJsonShapes(shapes).read(root);
  } catch (const JsonFault& fault) {
    shapes.error(std::min(fault.at, text.size()), fault.what());
  }
}

}  // namespace blocks::exchange
