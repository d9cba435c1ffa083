#include "sweep/json_fields.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

/// Throws std::runtime_error: "deck" is 3, not a text.
[[noreturn]] void refuse(const char* key, const Json& value, const std::string& what) {
  throw std::runtime_error(
      fmt::format("\"{}\" is {}, not {}", key,
                  value.dump(-1, ' ', false, Json::error_handler_t::replace), what));
}

}  // namespace

const Json& find_field(const Json& json, const char* key) {
  if (!json.is_object())
    throw std::runtime_error(fmt::format("it has no JSON object with \"{}\"", key));
  const auto found = json.find(key);
  if (found == json.end())
    throw std::runtime_error(fmt::format("\"{}\" is missing", key));
  return *found;
}

std::string read_text(const Json& json, const char* key) {
  const Json& value = find_field(json, key);
  if (!value.is_string())
    refuse(key, value, "a text");
  return value.get<std::string>();
}

double read_number(const Json& json, const char* key) {
  const Json& value = find_field(json, key);
  if (!value.is_number())
    refuse(key, value, "a number");
  return value.get<double>();
}

std::uint64_t read_whole_number(const Json& json, const char* key, std::uint64_t max) {
  const Json& value = find_field(json, key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > max)
    refuse(key, value, fmt::format("a whole number from 0 to {}", max));
  return value.get<std::uint64_t>();
}

const Json& read_list(const Json& json, const char* key) {
  const Json& value = find_field(json, key);
  if (!value.is_array())
    refuse(key, value, "a list");
  return value;
}

std::vector<std::string> read_texts(const Json& json, const char* key) {
  std::vector<std::string> all;
  for (const Json& one : read_list(json, key)) {
    if (!one.is_string())
      refuse(key, json.at(key), "a list of texts");
    all.push_back(one.get<std::string>());
  }
  return all;
}

}  // namespace blocks::sweep
