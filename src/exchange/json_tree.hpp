// JSON as a tree. Numbers are kept as written, and each node has its offset in the
// text. Private to src/exchange.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::exchange {

/// A node of the tree.
struct Json {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  std::size_t at = 0;             ///< offset in the text
  std::string_view number;        ///< as written
  std::string text;               ///< a decoded string, or "true" or "false"
  std::vector<std::string> keys;  ///< of an object, one per item
  std::vector<Json> items;        ///< of an array or object

  /// Returns the member of an object, or null if it does not exist. Throws JsonFault if
  /// it occurs twice.
  const Json* find(std::string_view key) const;
};

/// Returns "an array", "a number".
std::string name_of(Json::Kind kind);

/// A fault of the text, at an offset.
struct JsonFault : std::runtime_error {
  JsonFault(std::size_t offset, const std::string& message)
      : std::runtime_error(message), at(offset) {}
  std::size_t at;
};

/// Parses the text. Throws JsonFault if it is not JSON or is nested deeper than 32
/// levels.
Json parse_json(std::string_view text);

}  // namespace blocks::exchange
