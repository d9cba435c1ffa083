// Nodes of GeoJSON that every reader of it meets. Private to src/exchange.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "exchange/json_tree.hpp"
#include "exchange/ring.hpp"

namespace blocks::exchange {

/// Reads nodes and reports what is wrong with them. Reports is RingReader or
/// ShapeCollector.
template <class Reports> class GeoJsonNodes {
 public:
  explicit GeoJsonNodes(Reports& reports) : reports_(reports) {}

  /// Returns whether the node is of this kind; otherwise reports an error.
  bool expect(const Json& node, Json::Kind kind, const std::string& what) {
    if (node.kind == kind)
      return true;
    reports_.error(node.at, fmt::format("{}: expected {}, found {}", what,
                                        name_of(kind), name_of(node.kind)));
    return false;
  }

  /// Returns the member if it is of this kind; otherwise reports an error and returns
  /// null.
  const Json* member(const Json& object, const std::string& key, Json::Kind kind) {
    const Json* found = object.find(key);
    if (!found)
      reports_.error(object.at, fmt::format("\"{}\" is missing", key));
    return found && expect(*found, kind, "\"" + key + "\"") ? found : nullptr;
  }

  /// Returns the first two numbers of a position; otherwise reports an error and
  /// returns nullopt.
  std::optional<Position> position(const Json& node) {
    if (!expect(node, Json::Kind::array, "position"))
      return std::nullopt;
    if (node.items.size() < 2) {
      reports_.error(node.at, fmt::format("position: expected 2 numbers, found {}",
                                          node.items.size()));
      return std::nullopt;
    }
    if (node.items.size() > 2)
      reports_.saw_height(node.at);
    const Json &x = node.items[0], &y = node.items[1];
    if (!expect(x, Json::Kind::number, "x") || !expect(y, Json::Kind::number, "y"))
      return std::nullopt;
    return Position{WrittenNumber{x.number, x.at}, WrittenNumber{y.number, y.at}};
  }

 private:
  Reports& reports_;
};

/// Returns the property "layer" or, if it is given too, "Layer" as text; an empty text
/// if there is none.
inline std::string layer_of(const Json& properties) {
  std::string text;
  for (const char* key : {"layer", "Layer"})
    if (const Json* layer = properties.find(key))
      text =
          layer->kind == Json::Kind::number ? std::string(layer->number) : layer->text;
  return text;
}

}  // namespace blocks::exchange
