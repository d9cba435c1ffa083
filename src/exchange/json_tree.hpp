// JSON as a tree whose numbers stay digit for digit as written and whose nodes know
// where they stand. Private to src/exchange.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::exchange {

struct Json {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  std::size_t at = 0;             ///< offset in the text
  std::string_view number;        ///< as written
  std::string text;               ///< of a string, decoded; "true" or "false"
  std::vector<std::string> keys;  ///< of an object, one for each item
  std::vector<Json> items;        ///< of an array or object

  /// Member of an object; null when it is not there. Throws JsonFault when it stands
  /// there twice.
  const Json* find(std::string_view key) const;
};

/// "an array", "a number"
std::string name_of(Json::Kind kind);

struct JsonFault : std::runtime_error {
  JsonFault(std::size_t offset, const std::string& message)
      : std::runtime_error(message), at(offset) {}
  std::size_t at;
};

/// Throws JsonFault for what is no JSON and for nesting deeper than 32.
Json parse_json(std::string_view text);

}  // namespace blocks::exchange
