// Reads the fields of sweep.json and outcome.json, which may be damaged.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blocks::sweep {

/// Each function returns the field `key` of an object. They throw std::runtime_error
/// with a message for the user if `json` is no object, the field is missing, or it has
/// another type.
const nlohmann::ordered_json& find_field(const nlohmann::ordered_json& json,
                                         const char* key);
/// A text.
std::string read_text(const nlohmann::ordered_json& json, const char* key);
/// A number.
double read_number(const nlohmann::ordered_json& json, const char* key);
/// A whole number from 0 to `max`.
std::uint64_t read_whole_number(const nlohmann::ordered_json& json, const char* key,
                                std::uint64_t max);
/// A list.
const nlohmann::ordered_json& read_list(const nlohmann::ordered_json& json,
                                        const char* key);
/// A list of texts.
std::vector<std::string> read_texts(const nlohmann::ordered_json& json,
                                    const char* key);

}  // namespace blocks::sweep
